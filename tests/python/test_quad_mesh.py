"""The numpy façade: valid meshes, typed errors, progress and cancel."""

import json
import unittest

import invariants
import numpy as np
import surfaces

import anisoquad


class Surfaces(unittest.TestCase):
    """Valid all-quad meshes of surfaces of every kind."""

    def test_isotropic(self):
        for make in (surfaces.plane, surfaces.cylinder, surfaces.torus, surfaces.cube, surfaces.sphere):
            with self.subTest(make.__name__):
                points, triangles = make()
                invariants.check(self, points, triangles, anisoquad.quad_mesh(points, triangles))

    def test_wings_with_a_source(self):
        for name in ("wing_delta", "wing_swept"):
            with self.subTest(name):
                points, triangles, line = surfaces.wing(name)
                mesh = anisoquad.quad_mesh(points, triangles, [anisoquad.Source(line, passes=[4, 2, 2])])
                invariants.check(self, points, triangles, mesh)
                self.assertLess(mesh.report["quads"], len(triangles))

    def test_an_input_given_as_lists_is_the_same_as_arrays(self):
        points, triangles = surfaces.plane(4, 4)
        from_lists = anisoquad.quad_mesh(points.tolist(), triangles.tolist())
        from_arrays = anisoquad.quad_mesh(np.asfortranarray(points), triangles.astype(np.uint64))
        self.assertTrue(np.array_equal(from_lists.points, from_arrays.points))
        self.assertTrue(np.array_equal(from_lists.quads, from_arrays.quads))

    def test_the_same_input_gives_the_same_mesh(self):
        points, triangles, line = surfaces.wing()
        first, second = (anisoquad.quad_mesh(points, triangles, [anisoquad.Source(line, anisotropy=4)]) for _ in range(2))
        self.assertEqual(first.points.tobytes(), second.points.tobytes())
        self.assertEqual(first.quads.tobytes(), second.quads.tobytes())


class Rows(unittest.TestCase):
    """Anisotropic rows at the delta wing's leading edge."""

    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles, cls.line = surfaces.wing()
        source = anisoquad.Source(cls.line, passes=[4, 2, 2])
        cls.mesh = anisoquad.quad_mesh(cls.points, cls.triangles, [source], anisoquad.Options(record_stages=True))

    def test_rows_count_from_the_source_without_gaps(self):
        rows = np.unique(self.mesh.row)
        self.assertGreater(len(rows), 3)
        self.assertTrue(np.array_equal(rows, np.arange(len(rows))))

    def test_the_report_tells_every_pass_of_both_sides(self):
        passes = self.mesh.report["passes"]
        self.assertEqual({(entry["side"], entry["pass"]) for entry in passes},
                         {(side, pass_) for side in ("left", "right") for pass_ in (1, 2, 3)})
        self.assertTrue(all(entry["stopped"] for entry in passes))

    def test_stages_show_rows_and_merge_of_each_pass(self):
        names = [name for name, *_ in self.mesh.stages]
        for pass_ in (1, 2, 3):
            self.assertIn(f"pass {pass_}: rows", names)
            self.assertIn(f"pass {pass_}: merge", names)
        for name, points, faces, row in self.mesh.stages:
            with self.subTest(name):
                self.assertEqual(len(faces), len(row))
                self.assertLess(faces.max(), len(points))

    def test_one_side_only(self):
        mesh = anisoquad.quad_mesh(self.points, self.triangles, [anisoquad.Source(self.line, passes=[3], sides="left")])
        self.assertEqual({entry["side"] for entry in mesh.report["passes"]}, {"left"})

    def test_rows_asked_for_are_not_exceeded(self):
        mesh = anisoquad.quad_mesh(self.points, self.triangles, [anisoquad.Source(self.line, passes=[(2, 1)])])
        self.assertEqual({entry["rows"] for entry in mesh.report["passes"]}, {1})


class Report(unittest.TestCase):
    def test_it_is_json(self):
        points, triangles, line = surfaces.wing()
        report = anisoquad.quad_mesh(points, triangles, [anisoquad.Source(line, passes=[2])]).report
        self.assertEqual(json.loads(json.dumps(report, allow_nan=False)), report)
        self.assertEqual(report["triangles_in"], len(triangles))
        self.assertGreaterEqual(report["scaled_jacobian"]["mean"], report["scaled_jacobian"]["min"])


class Errors(unittest.TestCase):
    """Bad input is told by code and ids."""

    def setUp(self):
        self.points, self.triangles = surfaces.plane(4, 4)

    def assert_error(self, code, *arguments, **keywords):
        with self.assertRaises(anisoquad.MeshError) as caught:
            anisoquad.quad_mesh(*arguments, **keywords)
        self.assertEqual(caught.exception.code, code)
        return caught.exception

    def test_empty(self):
        self.assert_error("empty_mesh", self.points, [])
        self.assert_error("empty_mesh", [], [])

    def test_non_finite_coordinates(self):
        self.points[7] = np.nan
        error = self.assert_error("non_finite_coordinates", self.points, self.triangles)
        self.assertEqual((error.kind, error.ids), ("vertex", [7]))
        self.assertIn("7", str(error))

    def test_index_out_of_range(self):
        for bad in (-1, 25, 2**31, 2**40, -(2**40)):
            with self.subTest(bad):
                triangles = self.triangles.astype(np.int64)
                triangles[3, 1] = bad
                error = self.assert_error("index_out_of_range", self.points, triangles)
                self.assertEqual((error.kind, error.ids), ("facet", [3]))

    def test_degenerate_facet(self):
        self.triangles[3, 1] = self.triangles[3, 0]
        self.assertIn(3, self.assert_error("degenerate_facets", self.points, self.triangles).ids)

    def test_a_source_that_is_no_edge_path(self):
        self.assert_error("invalid_source", self.points, self.triangles, [[0, 24]])
        self.assert_error("invalid_source", self.points, self.triangles, [[0, 99]])

    def test_wrong_shapes_and_types(self):
        self.assert_error("invalid_input", self.points[:, :2], self.triangles)
        self.assert_error("invalid_input", self.points, self.triangles[:, :2])
        self.assert_error("invalid_input", self.points, self.triangles.astype(float))
        self.assert_error("invalid_input", [["a", "b", "c"]], self.triangles)

    def test_an_option_that_does_not_exist(self):
        with self.assertRaisesRegex(TypeError, "feature_angel"):
            anisoquad.Options(feature_angel=30)
        with self.assertRaisesRegex(TypeError, "feature_angle"):
            anisoquad.Options(feature_angle="steep")


class Progress(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = surfaces.plane(8, 8)

    def test_stages_are_told_and_fractions_never_fall(self):
        calls = []
        anisoquad.quad_mesh(self.points, self.triangles, progress=lambda *call: calls.append(call))
        fractions = [fraction for _, fraction in calls]
        self.assertGreater(len({stage for stage, _ in calls}), 1)
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(0.0 <= fractions[0] and fractions[-1] <= 1.0)

    def test_false_cancels(self):
        with self.assertRaises(anisoquad.Cancelled) as caught:
            anisoquad.quad_mesh(self.points, self.triangles, progress=lambda stage, fraction: False)
        self.assertEqual(caught.exception.code, "cancelled")

    def test_an_exception_comes_through(self):
        def fail(stage, fraction):
            raise KeyError(stage)

        with self.assertRaises(KeyError):
            anisoquad.quad_mesh(self.points, self.triangles, progress=fail)


class SharedSurfaces(unittest.TestCase):
    """Surfaces that others made, where they are at hand."""

    @unittest.skipUnless(surfaces.shared_folder(), "no shared surfaces here")
    def test_no_node_gathers_quads_without_end(self):
        # Turned by 180° about z this blended wing body once got nodes with 1860 quads.
        folder = surfaces.shared_folder() / "data/real/aero"
        points, triangles = anisoquad.io.read_triangles(folder / "zeroe_bwb_half.off")
        line = json.loads((folder / "zeroe_bwb_half.le.json").read_text())["leading_edge"]
        mesh = anisoquad.quad_mesh(points * [-1, -1, 1], triangles, [anisoquad.Source(line, anisotropy=8)])
        self.assertLessEqual(np.bincount(mesh.quads.ravel()).max(), 16)
        self.assertEqual(mesh.report["triangles_left"], 0)

    @unittest.skipUnless(surfaces.shared_folder(), "no shared surfaces here")
    def test_bad_inputs_are_refused_with_a_code(self):
        for name in ("fan3", "moebius", "triple_vierbein"):
            with self.subTest(name):
                points, triangles = anisoquad.io.read_triangles(surfaces.shared_folder() / "data/real/bad" / f"{name}.off")
                with self.assertRaises(anisoquad.MeshError) as caught:
                    anisoquad.quad_mesh(points, triangles)
                self.assertTrue(caught.exception.ids)
