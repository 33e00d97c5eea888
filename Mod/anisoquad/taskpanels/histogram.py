"""A histogram as a picture, by matplotlib."""

from PySide import QtGui


def histogram(values, title, columns, lines):
    """A QPixmap of a histogram of (n,) values, or None where matplotlib is not installed."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        return None
    figure = Figure(figsize=(columns / 100, lines / 100), dpi=100, layout="constrained")
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.hist(values, bins=40, color="#3465a4")
    axes.set_xlabel(title, fontsize=8)
    axes.tick_params(labelsize=7)
    axes.set_yscale("log", nonpositive="clip")
    canvas.draw()
    image = QtGui.QImage(bytes(canvas.buffer_rgba()), columns, lines, 4 * columns, QtGui.QImage.Format_RGBA8888)
    return QtGui.QPixmap.fromImage(image)
