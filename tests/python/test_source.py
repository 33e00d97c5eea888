"""Sources and the notation of passes."""

import unittest

import anisoquad
from anisoquad.source import format_passes, parse_passes


class Passes(unittest.TestCase):
    def test_every_notation(self):
        self.assertEqual(parse_passes("4, 2:6,2"), [(4, "auto"), (2, 6), (2, "auto")])
        self.assertEqual(parse_passes([4, (2, 6), [2, "auto"]]), [(4, "auto"), (2, 6), (2, "auto")])
        self.assertEqual(parse_passes(" "), [])

    def test_text_and_back(self):
        for text in ("", "3", "4, 2:6, 2"):
            self.assertEqual(format_passes(parse_passes(text)), text)

    def test_nonsense_is_refused(self):
        for bad in ("x", "4:", "0", "-2", "4,,2", "4:2:1", [2.5], [None], [(2, 0)]):
            with self.subTest(bad), self.assertRaises(anisoquad.MeshError):
                parse_passes(bad)

    def test_anisotropy_is_the_product_of_the_ratios(self):
        for anisotropy in (2, 3, 5, 6, 8, 16, 32):
            product = 1
            for ratio, _ in anisoquad.passes_for_anisotropy(anisotropy):
                product *= ratio
            self.assertEqual(product, anisotropy)
        self.assertEqual(anisoquad.passes_for_anisotropy(1), [])
        for bad in (0, -3, 2.5, True):
            with self.subTest(bad), self.assertRaises(anisoquad.MeshError):
                anisoquad.passes_for_anisotropy(bad)


class Sources(unittest.TestCase):
    def test_passes_or_anisotropy_but_not_both(self):
        self.assertEqual(anisoquad.Source([0, 1], anisotropy=8).passes, [(4, "auto"), (2, "auto")])
        self.assertEqual(anisoquad.Source([0, 1]).passes, [])
        with self.assertRaises(anisoquad.MeshError):
            anisoquad.Source([0, 1], passes=[2], anisotropy=2)

    def test_nonsense_is_refused(self):
        for keywords in ({"vertices": 5}, {"vertices": ["a"]}, {"vertices": [0, 1], "sides": "up"}):
            with self.subTest(keywords), self.assertRaises(anisoquad.MeshError):
                anisoquad.Source(**keywords)
