"""The command that adds a line source of anisotropy."""

import FreeCAD
import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .. import preferences
from .command import Command, newest, record, reference, transaction
from .quad_mesh_command import triangles_for
from .selection import is_mesh, is_mesh_or_shape, only, quad_meshes_on, selected_edges, selected_quad_mesh


class AddSourceCommand(Command):
    """Adds a source on the selected mesh, shape, quad mesh, or Part edges, and opens its panel to pick it in the view."""

    NAME = "AnisoQuad_AddSource"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_AddSource", "Add anisotropy source")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_AddSource",
                                "Pick a line on the selected mesh along which rows of long thin quads are built;\n"
                                "with edges of a Part object selected, they are the line")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_AddSource",
                                   "Adds a line along which rows of long, thin quads are built, such as the leading edge of a wing, "
                                   "and opens a panel to pick it in the view: a click starts the line, a further one extends it "
                                   "along the ridge, a double click takes the whole line, a click with Ctrl cuts it, Esc leaves "
                                   "picking. With edges of a Part object selected, the mesh edges on them are the line. With a quad "
                                   "mesh selected, that one gets the source.")
    ICON = "add_source"
    SHORTCUT = "Q, A"

    def IsActive(self):
        return super().IsActive() and bool(selected_edges() or selected_quad_mesh() or only(is_mesh_or_shape))

    def Activated(self):
        quads, edges = selected_quad_mesh(), selected_edges()
        base = quads.Base if quads else edges[0] if edges else only(is_mesh_or_shape)
        with transaction(FreeCAD.ActiveDocument, "Add anisotropy source", commit=False):
            if not is_mesh(base):
                base = triangles_for(base)
            source = add_source(base, [quads] if quads else quad_meshes_on(base), preferences.anisotropy(), edges=edges)
            FreeCADGui.ActiveDocument.setEdit(source.Name)


def add_source(base, quad_meshes, anisotropy, vertices=None, edges=None):
    """Make a source, and give it to the quad meshes; recorded. Returns the source object."""
    line = ""
    if vertices is not None:
        line = f", vertices={list(vertices)}"
    if edges is not None:
        line = f", edges=({reference(edges[0])}, {edges[1]!r})"
    record(f"anisoquad.make_source(FreeCAD.ActiveDocument, {reference(base)}{line}, anisotropy={anisotropy})")
    source = newest(FreeCAD.ActiveDocument)
    for quads in quad_meshes:
        quads_text = reference(quads)
        record(f"{quads_text}.Sources = {quads_text}.Sources + [{reference(source)}]")
    return source
