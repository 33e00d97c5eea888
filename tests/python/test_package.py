"""The package also where its compiled core can not be loaded."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import anisoquad


class WithoutCore(unittest.TestCase):
    def run_python(self, code):
        with tempfile.TemporaryDirectory() as folder:
            package = Path(folder) / "anisoquad"
            shutil.copytree(Path(anisoquad.__file__).parent, package, ignore=shutil.ignore_patterns("_core*", "__pycache__"))
            return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env={"PYTHONPATH": folder})

    def test_it_is_imported_and_says_what_to_do_when_used(self):
        run = self.run_python("import anisoquad\nprint('imported')\nanisoquad.quad_mesh")
        self.assertEqual(run.stdout, "imported\n")
        self.assertIn("compiled core is missing, or made for another Python; run `make build`", run.stderr.splitlines()[-1])

    def test_names(self):
        for name in anisoquad.__all__:
            self.assertIn(name, dir(anisoquad))
        with self.assertRaises(AttributeError):
            anisoquad.no_such_name


if __name__ == "__main__":
    unittest.main()
