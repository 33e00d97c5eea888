"""Every text that the core puts into a report is one that the workbench can translate."""

import re
import unittest
from pathlib import Path

import numpy as np

import anisoquad
from anisoquad.report_texts import STOPPED, WARNINGS, shown

CORE = Path(__file__).resolve().parents[2] / "cpp"


def upper(_, text):
    return re.sub(r"[a-z']+", lambda word: word.group().upper(), text)


def literals(path, call):
    """The texts that are put together in the calls of a function of a C++ file, as (text with {} for what is no literal)."""
    source = (CORE / path).read_text(encoding="utf-8")
    for arguments in re.findall(call + r"((?:[^;\"]|\"[^\"]*\")*);", source):
        pieces = re.findall(r'"([^"]*)"|(std::to_string|length_text)', arguments)
        yield "".join("{}" if number else text for text, number in pieces)


class ReportTexts(unittest.TestCase):
    def test_all_reasons_of_the_core_are_known(self):
        found = {*literals("anisotropy/rows.cpp", r"\bstop(?:_at_\w+)?\("), *literals("anisotropy/multi_pass.cpp", r"\.stopped = ")}
        self.assertEqual(found - {""}, set(STOPPED))

    def test_all_warnings_of_the_core_are_known(self):
        found = [*literals("quad_mesh.cpp", r"\bwarn\("), *literals("quad_mesh.cpp", r"why \+="), *literals("quad_mesh.cpp", r"warnings\.insert\("),
                 *literals("anisotropy/multi_pass.cpp", r"warnings\.push_back\(")]
        found = [text.removeprefix("; ").removesuffix(": ") for text in found if text]
        self.assertGreater(len(found), 7)
        self.assertEqual([text for text in found if text not in WARNINGS], [])

    def test_all_repairs_of_the_core_are_known(self):
        source = (CORE / "input" / "repair.cpp").read_text(encoding="utf-8")
        repairs = re.findall(r'add\(report\.\w+, "(\w+)", "(\w+)", "([^"]+)"\)', source)
        self.assertEqual(len(repairs), len(re.findall(r"\badd\(report\.", source)))
        for one, many, what in repairs:
            for noun in (one, many):
                self.assertIn(f"{{}} {noun} {what}", WARNINGS)

    def test_numbers_are_put_in(self):
        text = ("3 patches were remeshed before: 120 triangles became 88, edges up to 0.250000; "
                "2 of them have triangles too long and thin for quads (17 triangles); in 1 of them the triangles' size changes too fast")
        self.assertEqual(shown(text, upper), text.upper().replace("0.250000", "0.25"))
        self.assertEqual(shown("something new: 3 of it", upper), "something new: 3 of it")

    def test_what_a_run_tells_is_translated(self):
        points = np.array([[x, y, 0.0] for y in range(9) for x in range(9)], float)
        a = np.array([9 * y + x for y in range(8) for x in range(8)])
        triangles = np.concatenate([np.column_stack([a, a + 1, a + 10]), np.column_stack([a, a + 10, a + 9])])
        triangles = np.concatenate([triangles, triangles[:1]])  # one doubled
        mesh = anisoquad.quad_mesh(points, triangles, [anisoquad.Source(list(range(9)), anisotropy=2)], anisoquad.Options(repair=True, size=0.5))
        texts = [*mesh.report["warnings"], *(entry["stopped"] for entry in mesh.report["passes"])]
        self.assertGreaterEqual(len(texts), 3)
        for text in texts:
            self.assertEqual(re.findall("[a-z]", shown(text, upper)), [], text)


if __name__ == "__main__":
    unittest.main()
