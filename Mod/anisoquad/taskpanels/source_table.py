"""The table of sources in the quad mesh panel."""

from ..commands.command import reference
from ..compat import qt_widgets, translate
from ..errors import MeshError
from ..source import format_passes, parse_passes

SOURCE, LENGTH, EDGES, PASSES, SIDES = range(5)
_SIDES = ("both", "left", "right")
_NARROWEST = 30  # pixels


class SourceTable:
    """Shows source objects; passes and sides can be changed in place."""

    def __init__(self, table):
        self._table = table
        self.sources = []
        header, modes = table.horizontalHeader(), qt_widgets().QHeaderView
        header.setMinimumSectionSize(_NARROWEST)
        header.setSectionResizeMode(modes.ResizeToContents)
        header.setSectionResizeMode(SOURCE, modes.Stretch)  # takes what the others leave, its name shortened where that is little
        table.verticalHeader().hide()

    def fill(self, sources):
        """Show these source objects, as they are now."""
        self.sources = list(sources)
        self._table.setRowCount(len(self.sources))
        for row, source in enumerate(self.sources):
            self._show(row, SOURCE, source.Label)
            self._table.item(row, SOURCE).setToolTip(source.Label)
            self._show(row, LENGTH, _short(source.Length))
            self._table.item(row, LENGTH).setToolTip(source.Length.UserString)
            self._show(row, EDGES, str(source.EdgeCount))
            self._show(row, PASSES, source.Passes or f"1:{source.Anisotropy}", editable=True)
            box = qt_widgets().QComboBox()
            box.addItems([translate("SourcePanel", side) for side in _SIDES])
            box.setCurrentIndex(_SIDES.index(source.Sides))
            self._table.setCellWidget(row, SIDES, box)

    def selected(self):
        """The source of the current row, or None."""
        row = self._table.currentRow()
        return self.sources[row] if 0 <= row < len(self.sources) else None

    def lines(self):
        """Macro lines that give the sources what was typed. Raises MeshError when passes can not be read."""
        lines = []
        for row, source in enumerate(self.sources):
            wanted = _how(self._table.item(row, PASSES).text())
            wanted["Sides"] = _SIDES[self._table.cellWidget(row, SIDES).currentIndex()]
            lines += [f"{reference(source)}.{name} = {value!r}" for name, value in wanted.items() if getattr(source, name) != value]
        return lines

    def _show(self, row, column, text, editable=False):
        item = qt_widgets().QTableWidgetItem(text)
        if not editable:
            item.setFlags(item.flags() & ~_editable_flag())
        self._table.setItem(row, column, item)


def _short(length):
    """The length in the user's unit with four digits: "1745 mm" for 1745.14 mm."""
    _, factor, unit = length.getUserPreferred()
    number = length.Value / factor
    whole = len(str(int(abs(number)))) if abs(number) >= 1.0 else 1
    return f"{number:.{max(4 - whole, 0)}f} {unit}"


def _editable_flag():
    from PySide import QtCore

    return QtCore.Qt.ItemIsEditable


def _how(text):
    """{property: value} of "1:16" (maximum anisotropy) or "4:6, 2" (passes)."""
    text = text.strip()
    if text.startswith("1:") and "," not in text:
        if not text[2:].strip().isdigit() or int(text[2:]) < 1:
            raise MeshError(f"The maximum anisotropy is 1:1, 1:2 …, not {text!r}.", code="invalid_source")
        return {"Passes": "", "Anisotropy": int(text[2:])}
    return {"Passes": format_passes(parse_passes(text))}
