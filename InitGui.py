# FreeCAD's GUI runs this at start, after Init.py.
import FreeCADGui

from anisoquad.workbench import AnisoQuadWorkbench

FreeCADGui.addWorkbench(AnisoQuadWorkbench())
