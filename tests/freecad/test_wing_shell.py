"""The shell analysis of the examples: fewer elements, the same displacement."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "resources" / "examples" / "wing_shell"))


class WingShell(unittest.TestCase):
    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_a_third_of_the_elements_gives_the_tip_displacement_within_a_percent(self):
        import wing_shell

        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        wing_shell.OUT = Path(folder)
        (_, quads, displacement), (_, fewer_quads, other_displacement) = rows = wing_shell.run()
        print(wing_shell.table(rows))
        self.assertLessEqual(fewer_quads, 0.4 * quads)
        self.assertGreater(displacement, 1.0)
        self.assertLess(abs(other_displacement / displacement - 1.0), 0.01)
