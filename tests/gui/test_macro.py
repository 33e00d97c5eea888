"""What was done in the window, recorded as a macro, gives the same bytes without one."""

import shutil
import subprocess
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtCore
from window import ROOT, WindowTest, wait

from anisoquad.compat import qt_widgets

NAME = "recorded"


class Macro(WindowTest):
    def setUp(self):
        super().setUp()
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.wing = self.folder / "wing.FCStd"
        self.doc.saveAs(str(self.wing))
        FreeCAD.closeDocument(self.doc.Name)
        FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", str(self.folder))

    def record(self):
        def fill_in():
            dialog = qt_widgets().QApplication.activeModalWidget()
            dialog.findChild(qt_widgets().QLineEdit, "lineEditPath").setText(NAME)
            dialog.findChild(qt_widgets().QPushButton, "buttonStart").click()

        QtCore.QTimer.singleShot(300, fill_in)
        FreeCADGui.runCommand("Std_DlgMacroRecord")

    def open_wing(self):
        FreeCADGui.doCommand(f"FreeCAD.openDocument({str(self.wing)!r})")
        self.doc = FreeCAD.ActiveDocument
        self.base = self.doc.getObject("Wing")
        self.view = FreeCADGui.ActiveDocument.ActiveView
        self.view.setAnimationEnabled(False)
        self.view.viewTop()
        self.view.fitAll()
        wait()

    def pick_the_leading_edge(self):
        self.select(self.base)
        self.run_command("AnisoQuad_AddSource")
        form = self.panel("SourcePanel")
        form.findChild(object, "anisotropy").setValue(16)
        self.click(self.middle(*self.leading_edge[40:42]), times=2)
        self.button("OK").click()
        wait()

    def mesh(self):
        self.select(self.base)
        self.run_command("AnisoQuad_QuadMesh")
        self.wait_for_mesh(self.panel("QuadMeshPanel"))
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 30))

    def export(self, path):
        self.select(self.doc.getObject("QuadMesh"))
        with mock.patch.object(qt_widgets().QFileDialog, "getSaveFileName", return_value=(str(path), "")):
            self.run_command("AnisoQuad_Export")

    def test_a_recorded_macro_replays_headless_byte_for_byte(self):
        self.record()
        self.open_wing()
        self.pick_the_leading_edge()
        self.mesh()
        exported = self.folder / "wing.inp"
        self.export(exported)
        self.run_command("Std_MacroStopRecord")
        first = exported.read_bytes()
        self.assertIn("1:4", " ".join(self.doc.getObject("QuadMesh").RowsPerPass))
        exported.unlink()
        lines = (self.folder / f"{NAME}.FCMacro").read_text()
        self.assertIn("anisoquad.make_source", lines)
        script = self.folder / "replay.py"
        script.write_text(f"import sys\nsys.path.append({str(ROOT / 'Mod')!r})\n{lines}\nimport os\nos._exit(0)\n")
        run = subprocess.run(["freecadcmd", str(script)], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False)
        self.assertTrue(exported.exists(), run.stdout + run.stderr)
        self.assertEqual(exported.read_bytes(), first)
