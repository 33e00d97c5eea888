"""The figures of a run as read-only properties of a document object."""

import json

import FreeCAD

from ..compat import translate
from ..report_texts import shown
from ..translation import QT_TRANSLATE_NOOP
from . import properties

# (property, type, where it stands in the report, documentation)
_FIGURES = (
    ("Quads", "App::PropertyInteger", ("quads",), QT_TRANSLATE_NOOP("App::Property", "Number of quads")),
    ("Nodes", "App::PropertyInteger", ("nodes",), QT_TRANSLATE_NOOP("App::Property", "Number of corner nodes")),
    ("TrianglesIn", "App::PropertyInteger", ("triangles_in",), QT_TRANSLATE_NOOP("App::Property", "Number of triangles of the base mesh")),
    ("Reduction", "App::PropertyFloat", ("reduction_percent",), QT_TRANSLATE_NOOP("App::Property", "Percent of elements saved")),
    ("MinScaledJacobian", "App::PropertyFloat", ("scaled_jacobian", "min"), QT_TRANSLATE_NOOP("App::Property", "Scaled Jacobian of the worst quad")),
    ("MeanScaledJacobian", "App::PropertyFloat", ("scaled_jacobian", "mean"), QT_TRANSLATE_NOOP("App::Property", "Mean scaled Jacobian")),
    ("RegularNodes", "App::PropertyFloat", ("regular_percent",), QT_TRANSLATE_NOOP("App::Property", "Percent of interior nodes with four edges")),
    ("Hausdorff", "App::PropertyFloat", ("hausdorff",), QT_TRANSLATE_NOOP("App::Property", "Largest distance between the mesh and the base mesh")),
)


def add_report(obj):
    """Add the properties that are missing."""
    for name, type_, _, doc in _FIGURES:
        properties.add(obj, type_, name, "Result", doc, read_only=True)
    properties.add(obj, "App::PropertyStringList", "RowsPerPass", "Result", QT_TRANSLATE_NOOP("App::Property", "Rows of each pass, and why they stopped"), True)
    properties.add(obj, "App::PropertyStringList", "Warnings", "Result", QT_TRANSLATE_NOOP("App::Property", "What the mesher warns of"), True)
    properties.add(obj, "App::PropertyString", "Report", "Result", QT_TRANSLATE_NOOP("App::Property", "All figures of the run, as JSON"), True)
    properties.hide(obj, "Report")


def show_report(obj, report):
    """Write the figures of a run."""
    for name, _, path, _ in _FIGURES:
        value = report
        for key in path:
            value = value[key]
        setattr(obj, name, value)
    text = QT_TRANSLATE_NOOP("Report", "Source {source}, {side}, pass {pass_} (1:{ratio}): {rows} rows of {columns} columns; {why}")
    obj.RowsPerPass = [
        _in_words("Report", text).format(source=entry["source"] + 1, side=_in_words("SourcePanel", entry["side"]), pass_=entry["pass"],
                                         ratio=entry["ratio"], rows=entry["rows"], columns=entry["columns"], why=shown(entry["stopped"], _in_words))
        for entry in report["passes"]
    ]
    obj.Warnings = [shown(warning, _in_words) for warning in report["warnings"]]
    obj.Report = json.dumps(report)


def _in_words(context, text):
    """The text in the user's language; without a GUI, which alone knows it, in English."""
    return translate(context, text) if FreeCAD.GuiUp else text
