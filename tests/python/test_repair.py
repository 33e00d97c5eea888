"""Bad input: the typed error, or with repair a valid all-quad mesh. The surfaces are others'; without them the tests are skipped."""

import unittest

import invariants
import numpy as np
import surfaces

import anisoquad
from anisoquad.io import read_triangles

# What each is rejected for, None where it is valid; what the repair changes in it, None where nothing can be mended.
BAD = {
    "fan3": ("non_manifold_edges", {"cut_edges"}),
    "moebius": ("inconsistent_orientation", {"cut_edges", "new_vertices"}),
    "triple_vierbein": ("non_manifold_edges", {"cut_edges", "new_vertices"}),
    "derived/d_degenerate": ("degenerate_facets", {"degenerate_facets"}),
    "derived/d_empty": ("empty_mesh", None),
    "derived/d_flipped30": ("inconsistent_orientation", {"flipped_facets"}),
    "derived/d_index_range": ("index_out_of_range", {"out_of_range_facets"}),
    "derived/d_inside_out": (None, {"flipped_facets"}),
    "derived/d_isolated_dupfaces": ("duplicate_facets", {"duplicate_facets"}),
    "derived/d_nan_inf": ("non_finite_coordinates", {"non_finite_facets"}),
    "derived/d_soup_unwelded": (None, {"welded_vertices"}),
    "derived/d_truncated": ("unreadable_file", None),
    "derived/d_zero_bytes": ("unreadable_file", None),
}


def mesh(name, **options):
    points, triangles = read_triangles(surfaces.shared_folder() / "data" / "real" / "bad" / f"{name}.off")
    return points, triangles, anisoquad.quad_mesh(points, triangles, options=anisoquad.Options(**options))


@unittest.skipUnless(surfaces.shared_folder(), "the folder of others' surfaces is not there")
class BadSurfaces(unittest.TestCase):
    def test_without_repair_what_is_wrong_is_told_with_its_ids(self):
        for name, (code, _) in BAD.items():
            if code is None:
                continue
            with self.subTest(name), self.assertRaises(anisoquad.MeshError) as caught:
                mesh(name)
            self.assertEqual(caught.exception.code, code)
            self.assertEqual(bool(caught.exception.ids), code not in ("empty_mesh", "unreadable_file"))

    def test_with_repair_the_mesh_is_valid(self):
        for name, (code, changes) in BAD.items():
            with self.subTest(name):
                if changes is None:
                    with self.assertRaises(anisoquad.MeshError) as caught:
                        mesh(name, repair=True)
                    self.assertEqual(caught.exception.code, code)
                    continue
                result = mesh(name, repair=True, validate=True)[2]
                report = result.report
                self.assertEqual((report["triangles_left"], report["inverted"]), (0, 0))
                self.assertEqual(report["euler_in"], report["euler_out"])
                self.assertEqual(invariants.directed_edges_used_twice(result.quads), 0)
                self.assertLessEqual(changes, {kind for kind, count in report["repair"].items() if count})
                self.assertIn("repaired", report["warnings"][0])

    def test_mending_gives_back_the_surface_that_was_spoilt(self):
        points, triangles = read_triangles(surfaces.shared_folder() / "data" / "real" / "general" / "spot.off")
        for name in ("derived/d_degenerate", "derived/d_flipped30", "derived/d_inside_out", "derived/d_isolated_dupfaces",
                     "derived/d_soup_unwelded"):
            with self.subTest(name):
                invariants.check(self, points, triangles, mesh(name, repair=True)[2])


class Sources(unittest.TestCase):
    def test_ids_of_a_soup_stand_for_the_welded_vertices(self):
        points, triangles = surfaces.plane(12, 8)
        soup = points[triangles].reshape(-1, 3)
        corner = {int(vertex): index for index, vertex in enumerate(triangles.ravel())}
        line = [corner[4 * 13 + i] for i in range(13)]  # the middle line
        source = anisoquad.Source(line, passes=[2])
        result = anisoquad.quad_mesh(soup, np.arange(len(soup)).reshape(-1, 3), [source], anisoquad.Options(repair=True))
        invariants.check(self, points, triangles, result)
        self.assertGreater(result.row.max(), 0)
        self.assertEqual(result.report["repair"]["welded_vertices"], len(soup) - len(points))


if __name__ == "__main__":
    unittest.main()
