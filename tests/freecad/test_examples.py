"""The examples that start from a Part shape, and the demo."""

import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "resources" / "examples"))


class Examples(unittest.TestCase):
    def make(self, module):
        doc = FreeCAD.newDocument("Example")
        self.addCleanup(FreeCAD.closeDocument, doc.Name)
        quads = module.make(doc)
        doc.recompute()
        self.assertEqual(quads.getStatusString(), "Valid")
        self.assertEqual(quads.FemMesh.QuadrangleCount, quads.FemMesh.FaceCount)
        self.assertGreaterEqual(quads.Sources[0].EdgeCount, 1)
        self.assertFalse(all(": 0 rows" in line for line in quads.RowsPerPass), list(quads.RowsPerPass))
        return quads

    def test_swept_wing(self):
        import swept_wing

        self.assertAlmostEqual(self.make(swept_wing).Sources[0].Length.Value, (swept_wing.SPAN**2 + swept_wing.SWEEP**2) ** 0.5, delta=1.0)

    def test_nacelle(self):
        import nacelle

        source = self.make(nacelle).Sources[0]
        self.assertEqual(source.Vertices[0], source.Vertices[-1])

    def test_the_demo_leaves_its_files(self):
        freecad = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
        run = subprocess.run([freecad, str(ROOT / "resources" / "examples" / "wing_demo.py")], stdin=subprocess.DEVNULL,
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr[-1000:])
        left = {path.name for path in (ROOT / "build" / "demo").iterdir() if path.stat().st_size > 0}
        self.assertEqual(left, {"wing.FCStd", "wing.inp", "wing.vtu", "report.json", "wing.png"})


if __name__ == "__main__":
    unittest.main()
