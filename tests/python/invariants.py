"""What holds for every quad mesh that comes out, computed from the arrays alone."""

import numpy as np

from anisoquad.quality import scaled_jacobian


def check(test, points, triangles, mesh):
    """Fail the test where the mesh is not a valid all-quad mesh of the same surface."""
    _check_arrays(test, mesh)
    test.assertEqual(directed_edges_used_twice(mesh.quads), 0, "an edge with two faces on one side")
    test.assertEqual(euler(mesh.quads), euler(triangles), "Euler characteristic")
    test.assertEqual(boundary_loops(mesh.quads), boundary_loops(triangles), "number of boundary loops")
    test.assertEqual(len(np.unique(mesh.quads)), len(mesh.points), "points without a quad")
    test.assertGreater(scaled_jacobian(mesh.points, mesh.quads).min(), 0.0, "an inverted quad")
    area_in, area_out = area(points, triangles), area(mesh.points, mesh.quads)
    test.assertLess(np.linalg.norm(area_out.sum(axis=0) - area_in.sum(axis=0)), 0.02 * np.linalg.norm(area_in, axis=1).sum())
    test.assertTrue(0.95 < np.linalg.norm(area_out, axis=1).sum() / np.linalg.norm(area_in, axis=1).sum() < 1.05, "area")
    lines = undirected(mesh.line_edges[:, :2])
    test.assertEqual(lines - undirected(edges(mesh.quads)), set(), "a feature line off the mesh's edges")
    test.assertEqual(len(boundary_edges(mesh.quads) - lines), 0, "boundary edges on no feature line")


def _check_arrays(test, mesh):
    quads = len(mesh.quads)
    test.assertEqual(mesh.points.dtype, np.float64)
    test.assertEqual(mesh.quads.dtype, np.int32)
    test.assertEqual(mesh.points.shape[1:], (3,))
    test.assertEqual(mesh.quads.shape[1:], (4,))
    test.assertEqual(mesh.line_edges.shape[1:], (3,))
    for field in ("row", "pass_", "source", "patch"):
        test.assertEqual(getattr(mesh, field).shape, (quads,), field)
    for field in ("node_line", "node_input"):
        test.assertEqual(getattr(mesh, field).shape, (len(mesh.points),), field)
    test.assertTrue(np.array_equal(mesh.row > 0, mesh.source >= 0), "rows and sources disagree")
    test.assertTrue(np.array_equal(mesh.row > 0, mesh.pass_ > 0), "rows and passes disagree")
    test.assertTrue(np.isfinite(mesh.points).all())
    test.assertTrue(((mesh.quads >= 0) & (mesh.quads < len(mesh.points))).all())
    test.assertEqual(mesh.report["quads"], quads)
    test.assertEqual(mesh.report["nodes"], len(mesh.points))
    test.assertEqual((mesh.report["triangles_left"], mesh.report["inverted"]), (0, 0), "triangles left, inverted quads")
    test.assertTrue(mesh.valid)


def edges(faces):
    """(E,2) directed edges of all faces."""
    return np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)


def undirected(pairs):
    return {(min(a, b), max(a, b)) for a, b in np.asarray(pairs).tolist()}


def directed_edges_used_twice(faces):
    pairs = edges(faces)
    return len(pairs) - len(np.unique(pairs, axis=0))


def euler(faces):
    return len(np.unique(faces)) - len(undirected(edges(faces))) + len(faces)


def boundary_edges(faces):
    directed = set(map(tuple, edges(faces).tolist()))
    return {(min(a, b), max(a, b)) for a, b in directed if (b, a) not in directed}


def boundary_loops(faces):
    """Number of loops, for a surface whose boundary nodes have two boundary edges each."""
    parent = {}

    def root(node):
        while parent.setdefault(node, node) != node:
            node = parent[node]
        return node

    for a, b in boundary_edges(faces):
        parent[root(a)] = root(b)
    return len({root(node) for node in list(parent)})


def area(points, faces):
    """(F,3) area vectors."""
    corners = np.asarray(points)[faces]
    if faces.shape[1] == 3:
        return 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return 0.5 * np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
