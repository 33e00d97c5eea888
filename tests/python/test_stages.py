"""Every stage that a run can tell of has a title, and so a translation (see test_translations.py)."""

import re
import sys
import unittest
from pathlib import Path

from surfaces import plane

import anisoquad
from anisoquad import gmsh
from anisoquad.stages import TITLES, stage_title

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "resources" / "translations"))

import update  # noqa: E402


class Stages(unittest.TestCase):
    def test_those_in_the_cores_sources(self):
        named = set()
        for path in (ROOT / "cpp").rglob("*.cpp"):
            named.update(re.findall(r'\bbegin(?:_stage)?\("([^"]+)"', path.read_text(encoding="utf-8")))
        self.assertGreater(len(named), 8)
        self.assertEqual({*named, gmsh.STAGE}, set(TITLES))

    def test_those_that_a_run_tells_of(self):
        points, triangles = plane()
        told = set()
        anisoquad.quad_mesh(points, triangles, [anisoquad.Source([0, 1, 2, 3], passes=[2])], anisoquad.Options(repair=True, size=2.0),
                            progress=lambda stage, fraction: told.add(stage))
        self.assertGreater(len(told), 8)
        self.assertEqual(told - set(TITLES), set())

    def test_titles_are_translated(self):
        for language in update.LANGUAGES:
            known = update.read(update.FOLDER / f"AnisoQuad_{language}.ts")
            for title in TITLES.values():
                self.assertTrue(known.get(("Stages", title)), (language, title))

    def test_what_is_not_known_is_shown_as_it_is(self):
        self.assertEqual(stage_title("novel"), "novel")


if __name__ == "__main__":
    unittest.main()
