"""Ring 1 needs no FreeCAD, ring 2 no GUI."""

import importlib
import pkgutil
import subprocess
import sys
import unittest
from pathlib import Path

import FreeCAD

import anisoquad

GUI_FOLDERS = ("viewproviders", "commands", "taskpanels", "picking")
GUI_MODULES = ("workbench", "preferences", "escape", "__main__")


class Rings(unittest.TestCase):
    def modules(self):
        package = Path(anisoquad.__file__).parent
        for module in pkgutil.walk_packages([str(package)], "anisoquad."):
            parts = module.name.split(".")
            if parts[1] not in GUI_FOLDERS and parts[1] not in GUI_MODULES:
                yield module.name

    def test_no_gui_comes_along(self):
        self.assertFalse(FreeCAD.GuiUp)
        names = list(self.modules())
        self.assertIn("anisoquad.objects.quad_mesh_object", names)
        for name in names:
            importlib.import_module(name)
        gui = [name for name in sys.modules if name.split(".")[0] in ("FreeCADGui", "FemGui", "MeshGui", "pivy")
               or name.startswith(("PySide", "shiboken", "PyQt"))]
        self.assertEqual(gui, [])

    def test_meshing_needs_no_freecad(self):
        code = ("import sys, anisoquad, anisoquad.io, anisoquad.cli, anisoquad.picture\n"
                "assert 'FreeCAD' not in sys.modules\n"
                "print(len(anisoquad.quad_mesh([[0,0,0],[1,0,0],[1,1,0],[0,1,0]], [[0,1,2],[0,2,3]]).quads))\n")
        run = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False,
                             env={"PYTHONPATH": str(Path(anisoquad.__file__).parents[1])})
        self.assertEqual(run.stderr, "")
        self.assertGreaterEqual(int(run.stdout), 1)

    def test_the_add_on_was_put_on_the_path_by_its_init(self):
        mod = str(Path(anisoquad.__file__).parents[1])
        self.assertEqual(sys.path.count(mod), 1)
        self.assertFalse(any(name.startswith("Mod.") for name in sys.modules))
