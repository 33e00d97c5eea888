"""The command: exit codes, messages, files."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import anisoquad

DATA = Path(__file__).resolve().parents[1] / "data"


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_command(self, *arguments):
        environment = {**os.environ, "PYTHONPATH": str(Path(anisoquad.__file__).parents[1])}
        return subprocess.run([sys.executable, "-m", "anisoquad", *map(str, arguments)], env=environment,
                              capture_output=True, text=True, check=False)

    def test_a_wing(self):
        out, report = self.folder / "wing.vtu", self.folder / "report.json"
        run = self.run_command(DATA / "wing_delta.off", out, "--source", DATA / "wing_delta.json", "--passes", "4,2,2",
                               "--feature-angle", "45", "--report", report)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn("quads", run.stdout)
        self.assertTrue(out.exists())
        self.assertEqual(len({entry["pass"] for entry in json.loads(report.read_text())["passes"]}), 3)

    def test_several_and_closed_sources(self):
        square = "OFF\n5 4 8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"
        surface = self.folder / "square.off"
        surface.write_text(square)
        for content in ({"sources": [[0, 1], [2, 3]]}, {"leading_edge": [0, 1, 2, 3], "closed": True}):
            with self.subTest(content):
                source = self.folder / "source.json"
                source.write_text(json.dumps(content))
                run = self.run_command(surface, self.folder / "square.obj", "--source", source)
                self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_repair_splits_facets_with_more_corners_and_tells_it(self):
        surface = self.folder / "quads.off"
        surface.write_text("OFF\n6 2 7\n0 0 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n0 1 0\n4 0 1 4 5\n4 1 2 3 4\n")
        self.assertEqual(self.run_command(surface, self.folder / "out.obj").returncode, 2)
        run = self.run_command(surface, self.folder / "out.obj", "--repair")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn("2 facets with more than three corners", run.stdout)

    def test_bad_input_is_one_line_and_exit_code_2(self):
        wing, out = DATA / "wing_delta.off", self.folder / "x.vtu"
        nonsense = self.folder / "nonsense.json"
        nonsense.write_text('{"leading_edge": ["a", 1.5]}')
        off_path = self.folder / "off_path.json"
        off_path.write_text('{"leading_edge": [0, 4000]}')
        empty = self.folder / "empty.off"
        empty.write_text("OFF\n0 0 0\n")
        cases = [
            [],
            [wing],
            ["absent.off", out],
            [self.folder, out],
            [empty, out],
            [wing, self.folder / "x.jpg"],
            [wing, self.folder / "absent" / "x.vtu"],
            [wing, out, "--passes", "4,2"],
            [wing, out, "--source", "absent.json"],
            [wing, out, "--source", wing],
            [wing, out, "--source", nonsense],
            [wing, out, "--source", off_path],
            [wing, out, "--source", DATA / "wing_delta.json", "--passes", "4,x"],
            [wing, out, "--source", DATA / "wing_delta.json", "--anisotropy", "0"],
            [wing, out, "--source", DATA / "wing_delta.json", "--anisotropy", "4", "--passes", "4"],
            [wing, out, "--feature-angle", "steep"],
            [wing, out, "--wrong"],
        ]
        for arguments in cases:
            with self.subTest(" ".join(map(str, arguments))):
                run = self.run_command(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
                self.assertNotIn("Traceback", run.stderr)
                self.assertFalse(out.exists())
