"""The workbench without its compiled core: it is there, and says what is missing."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from window import ROOT

MACRO = """
import os
import FreeCADGui
from PySide import QtCore
from anisoquad.compat import qt_widgets


def run():
    FreeCADGui.activateWorkbench("AnisoQuadWorkbench")
    qt_widgets().QApplication.processEvents()
    views = FreeCADGui.getMainWindow().findChildren(qt_widgets().QTextEdit)
    text = "\\n".join(view.toPlainText() for view in views)
    with open({result!r}, "w") as file:
        file.write(FreeCADGui.activeWorkbench().name() + "\\n" + text)
    os._exit(0)


QtCore.QTimer.singleShot(0, run)
"""


class WithoutCore(unittest.TestCase):
    def test_it_loads_and_the_report_view_says_what_to_do(self):
        home = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, home)
        addon = home / "Mod" / "AnisoQuad"
        addon.mkdir(parents=True)
        for name in ("Init.py", "InitGui.py", "package.xml"):
            shutil.copy(ROOT / name, addon)
        shutil.copytree(ROOT / "resources", addon / "resources")
        shutil.copytree(ROOT / "Mod", addon / "Mod", ignore=shutil.ignore_patterns("_core*", "__pycache__"))
        result = home / "result"
        macro = home / "look.FCMacro"
        macro.write_text(MACRO.format(result=str(result)))
        environment = dict(os.environ, HOME=str(home), FREECAD_USER_HOME=str(home))
        subprocess.run(["freecad", str(macro)], env=environment, timeout=120, check=False, capture_output=True, stdin=subprocess.DEVNULL)
        text = result.read_text()
        self.assertTrue(text.startswith("AnisoQuadWorkbench\n"), text)
        self.assertIn("compiled core is missing, or made for another Python; run `make build`", text)
