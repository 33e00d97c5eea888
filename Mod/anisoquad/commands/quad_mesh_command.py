"""The command that makes a quad mesh of the selected triangles or Part shape."""

import FreeCAD
import FreeCADGui

from PySide.QtCore import QT_TRANSLATE_NOOP

from .. import preferences
from .command import Command, newest, record, reference, transaction
from .selection import free_sources, is_mesh, is_mesh_or_shape, only


class QuadMeshCommand(Command):
    """Quad mesh from mesh: makes the object, opens its panel, and starts meshing."""

    NAME = "AnisoQuad_QuadMesh"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_QuadMesh", "Quad mesh from mesh")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_QuadMesh",
                                "Make an all-quad surface mesh of the selected triangle mesh or Part shape,\n"
                                "with the sources that were added to it before")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_QuadMesh",
                                   "Makes a quad mesh of the selected triangle mesh, and opens its panel, in which meshing starts at "
                                   "once. A Part shape is triangulated first. Sources that were added to the triangles before get "
                                   "their rows of long, thin quads. The quad mesh follows its triangles, sources and options: when "
                                   "they change, it is made anew. With an active analysis it becomes a part of it.")
    ICON = "quad_mesh"
    SHORTCUT = "Q, M"

    def IsActive(self):
        return super().IsActive() and only(is_mesh_or_shape) is not None

    def Activated(self):
        with transaction(FreeCAD.ActiveDocument, "Quad mesh from mesh", commit=False):
            base = only(is_mesh_or_shape)
            quads = add_quad_mesh(base if is_mesh(base) else triangles_for(base))
            quads.purgeTouched()  # the panel meshes what holds no quads yet, off the window's thread
            FreeCADGui.ActiveDocument.setEdit(quads.Name)


def add_quad_mesh(base):
    """Make a quad mesh of a mesh object, with its free sources, in the active analysis; recorded. Returns the object."""
    how = f"base={reference(base)}"
    sources = free_sources(base)
    if sources:
        how += f", sources=[{', '.join(map(reference, sources))}]"
    if preferences.element_order() == 2:
        how += ", element_order=2"
    record(f"anisoquad.make_quad_mesh(FreeCAD.ActiveDocument, {how})")
    quads = newest(base.Document)
    analysis = active_analysis(base.Document)
    if analysis is not None:
        record(f"{reference(analysis)}.addObject({reference(quads)})")
    return quads


def triangles_for(shape):
    """The tessellation of a Part object, made and recorded where there is none yet."""
    from ..objects.triangles_object import triangles_of

    triangles = triangles_of(shape)
    if triangles is None:
        record(f"anisoquad.make_triangles(FreeCAD.ActiveDocument, {reference(shape)})", "FreeCAD.ActiveDocument.recompute()")
        triangles = newest(FreeCAD.ActiveDocument)
    return triangles


def active_analysis(doc):
    """The FEM analysis that is active in this document, or None."""
    import FemGui

    analysis = FemGui.getActiveAnalysis()
    return analysis if analysis is not None and analysis.Document is doc else None
