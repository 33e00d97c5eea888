"""What tests of meshes on Part shapes share."""

import json

from documents import DocumentTest
from shapes import largest_distance


class PartTest(DocumentTest):
    def assert_good(self, quads, shape):
        self.assertEqual(quads.getStatusString(), "Valid")
        report = json.loads(quads.Report)
        self.assertEqual((report["inverted"], report["triangles_left"]), (0, 0))
        self.assertEqual(quads.FemMesh.QuadrangleCount, quads.FemMesh.FaceCount)
        self.assertLess(largest_distance(shape, quads.FemMesh), 1e-7 * shape.BoundBox.DiagonalLength)
