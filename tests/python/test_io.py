"""Files in and out."""

import tempfile
import unittest
from pathlib import Path

import meshio
import numpy as np
import surfaces
from small_mesh import two_quads

import anisoquad
from anisoquad.io import read_and_split, read_triangles, write_mesh
from anisoquad.second_order import second_order

OFF = "OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, content=None):
        path = self.folder / name
        if content is not None:
            path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path


class Read(Folder):
    def test_all_formats_give_the_same_surface(self):
        points, triangles = surfaces.sphere(3)
        for name in ("a.off", "a.obj", "a.ply", "a.stl"):
            with self.subTest(name):
                path = self.file(name)
                meshio.Mesh(points, [("triangle", triangles)]).write(path)
                read_points, read = read_triangles(path)
                self.assertEqual((len(read_points), read.shape), (len(points), triangles.shape))
                self.assertTrue(np.allclose(np.sort(read_points[read].mean(axis=1), axis=0),
                                            np.sort(points[triangles].mean(axis=1), axis=0), atol=1e-5))
                if name != "a.stl":
                    self.assertTrue(np.array_equal(read, triangles))

    def test_text_and_binary_stl_give_the_same_points_in_the_order_of_the_file(self):
        points, triangles = surfaces.sphere(3)
        read = []
        for name, binary in (("text.stl", False), ("binary.stl", True)):
            path = self.file(name)
            meshio.Mesh(np.float32(points), [("triangle", triangles)]).write(path, binary=binary)
            read.append(read_triangles(path))
        self.assertTrue(np.allclose(read[0][0], read[1][0], atol=1e-6))
        self.assertTrue(np.array_equal(read[0][1], read[1][1]))
        _, first = np.unique(read[1][1].ravel(), return_index=True)
        self.assertTrue(np.all(np.diff(first) > 0))

    def test_off_with_comments_colours_and_counts_in_the_first_line(self):
        for text in (OFF, "# a square\n" + OFF.replace("0 1 2\n", "0 1 2 255 0 0\n"), OFF.replace("OFF\n", "OFF ")):
            points, triangles = read_triangles(self.file("a.off", text))
            self.assertEqual(triangles.tolist(), [[0, 1, 2], [0, 2, 3]])
            self.assertEqual(points.shape, (4, 3))

    def test_off_with_colours_and_normals_of_vertices(self):
        for keyword, more in (("COFF", " 255 0 0 255"), ("NOFF", " 0 0 1"), ("CNOFF", " 0 0 1 255 0 0 255")):
            lines = OFF.splitlines()
            text = "\n".join([keyword, lines[1]] + [line + more for line in lines[2:6]] + lines[6:])
            points, triangles = read_triangles(self.file("a.off", text))
            self.assertEqual(triangles.tolist(), [[0, 1, 2], [0, 2, 3]])
            self.assertEqual(points.tolist(), [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
        for keyword in ("4OFF", "nOFF", "OFFX"):
            with self.assertRaisesRegex(anisoquad.MeshError, "does not begin with OFF"):
                read_triangles(self.file("a.off", OFF.replace("OFF", keyword)))

    def test_ply_with_what_no_reader_knows_is_told_by_its_name(self):
        ply = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\n{}end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2{}\n")
        for more, values, told in (("element edge 1\nproperty int vertex1\n", "\n0", "edge"),
                                   ("property list uchar float texcoord\n", " 2 0 0", "float")):
            with self.assertRaisesRegex(anisoquad.MeshError, told):
                read_triangles(self.file("a.ply", ply.format(more, values)))

    def test_obj_with_negative_ids_textures_and_colours(self):
        points, triangles = read_triangles(self.file("a.obj", "v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nvt 0 0\nf -3/1 -2//1 -1\n"))
        self.assertEqual(triangles.tolist(), [[0, 1, 2]])
        self.assertEqual(points.shape, (3, 3))

    def test_what_can_not_be_read_is_told_in_one_line(self):
        bad = {
            "absent.off": None,
            "empty.off": "",
            "empty.stl": "",
            "empty.ply": "",
            "cut.off": OFF[:-20],
            "garbage.off": b"\x00\xff\x13" * 50,
            "garbage.stl": b"\x00\xff\x13" * 50,
            "garbage.ply": b"\x00\xff\x13" * 50,
            "words.obj": "v a b c\n",
            "quads.obj": "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
            "counts.off": "OFF\n-1 2 3\n",
            "picture.jpg": "",
            "huge_count.stl": b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 50,
            "cut.stl": b"\0" * 80 + b"\x02\0\0\0" + b"\0" * 50,
            "huge_count.ply": "ply\nformat binary_little_endian 1.0\nelement vertex 999999999999\nproperty float x\n"
                              "property float y\nproperty float z\nelement face 1\n"
                              "property list uchar int vertex_indices\nend_header\n",
            "cut.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n",
            "huge_id.obj": "v 0 0 0\nf 1 2 99999999999999999999\n",
        }
        for name, content in bad.items():
            with self.subTest(name), self.assertRaises(anisoquad.MeshError) as caught:
                read_triangles(self.file(name, content))
            self.assertEqual(caught.exception.code, "unreadable_file")
            self.assertIn(name, str(caught.exception))

    def test_facets_with_more_corners_are_split_where_asked_for(self):
        square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
        with self.assertRaisesRegex(anisoquad.MeshError, "4 corners.*repair") as caught:
            read_triangles(self.file("a.obj", square))
        self.assertEqual((caught.exception.kind, caught.exception.ids), ("facet", [0]))
        points, triangles, split = read_and_split(self.file("a.obj", square))
        self.assertEqual((points.shape, triangles.shape, triangles.dtype, split), ((4, 3), (2, 3), np.int32, 1))
        with self.assertRaises(anisoquad.MeshError) as caught:
            read_and_split(self.file("b.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"))
        self.assertEqual(caught.exception.code, "unreadable_file")

    def test_ids_out_of_range_are_named_by_the_core(self):
        for last in ("7", "-1", "4294967296"):
            with self.subTest(last), self.assertRaises(anisoquad.MeshError) as caught:
                anisoquad.quad_mesh(*read_triangles(self.file("a.off", OFF.replace("3 0 2 3", f"3 0 2 {last}"))))
            self.assertEqual((caught.exception.code, caught.exception.ids), ("index_out_of_range", [1]))


class Write(Folder):
    def test_vtu_and_msh_keep_points_quads_and_rows(self):
        mesh = two_quads()
        for name in ("a.vtu", "a.msh"):
            with self.subTest(name):
                write_mesh(self.file(name), mesh)
                read = meshio.read(self.file(name))
                self.assertTrue(np.array_equal(read.points, mesh.points))
                self.assertTrue(np.array_equal(read.get_cells_type("quad"), mesh.quads))
        read = meshio.read(self.file("a.vtu"))
        for field in ("row", "pass", "source", "patch", "scaled_jacobian"):
            self.assertIn(field, read.cell_data)
        self.assertEqual(read.cell_data["row"][0].tolist(), [1, 0])
        read = meshio.read(self.file("a.msh"))
        self.assertTrue(np.array_equal(read.get_cells_type("line"), mesh.line_edges[:, :2]))
        self.assertEqual(read.get_cell_data("gmsh:physical", "quad").tolist(), [1, 2])

    def test_inp_has_shells_and_sets(self):
        write_mesh(self.file("a.inp"), two_quads())
        text = self.file("a.inp").read_text()
        self.assertIn("*ELEMENT, TYPE=S4, ELSET=Eall\n1,1,2,3,4\n2,2,5,6,3\n", text)
        self.assertIn("*ELSET, ELSET=Source_1_Pass_1\n1,\n", text)
        self.assertIn("*NSET, NSET=Line_2\n5,6,\n", text)
        self.assertTrue(np.array_equal(meshio.read(self.file("a.inp")).points, two_quads().points))

    def test_second_order(self):
        points, triangles = surfaces.plane(6, 6)
        mesh = anisoquad.quad_mesh(points, triangles)
        quadratic = second_order(mesh, points, triangles, 40.0)
        for name in ("a.vtu", "a.msh"):
            with self.subTest(name):
                write_mesh(self.file(name), mesh, quadratic)
                read = meshio.read(self.file(name))
                self.assertTrue(np.array_equal(read.get_cells_type("quad8"), quadratic.quads))
                self.assertTrue(np.allclose(read.points, quadratic.points))
        write_mesh(self.file("a.inp"), mesh, quadratic)
        text = self.file("a.inp").read_text()
        self.assertIn("*ELEMENT, TYPE=S8, ELSET=Eall\n1," + ",".join(map(str, quadratic.quads[0] + 1)) + "\n", text)
        nodes = text.split("NSET=Line_1\n")[1].split("*")[0].replace("\n", "").strip(",").split(",")
        corners = np.unique(mesh.line_edges[mesh.line_edges[:, 2] == 0, :2])
        self.assertEqual(len(nodes), 2 * len(corners) - 1)

    def test_obj_and_su2(self):
        mesh = two_quads()
        write_mesh(self.file("a.obj"), mesh)
        self.assertTrue(np.array_equal(meshio.read(self.file("a.obj")).points, mesh.points))
        write_mesh(self.file("a.su2"), mesh)
        text = self.file("a.su2").read_text()
        self.assertIn("NDIME= 3\nNELEM= 2\n9 0 1 2 3 0\n9 1 4 5 2 1\nNPOIN= 6\n", text)
        self.assertIn("MARKER_TAG= Line_1\nMARKER_ELEMS= 1\n3 0 3\n", text)

    def test_what_can_not_be_written_is_told(self):
        for path in (self.file("a.jpg"), self.folder / "absent" / "a.vtu", self.folder / "absent" / "a.inp"):
            with self.subTest(path.name), self.assertRaises(anisoquad.MeshError) as caught:
                write_mesh(path, two_quads())
            self.assertEqual(caught.exception.code, "unwritable_file")
