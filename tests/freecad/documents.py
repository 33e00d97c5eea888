"""Documents and meshes for the tests."""

import unittest

import FreeCAD
import Mesh


def square(cells=6):
    """A Mesh.Mesh of a square of unit cells; point 0 … cells are its lower edge, in this order."""
    size = cells + 1
    points = [FreeCAD.Vector(i, j, 0) for j in range(size) for i in range(size)]
    facets = []
    for j in range(cells):
        for i in range(cells):
            a, b, c, d = j * size + i, j * size + i + 1, (j + 1) * size + i + 1, (j + 1) * size + i
            facets += [(a, b, c), (a, c, d)]
    return Mesh.Mesh((points, facets))


class DocumentTest(unittest.TestCase):
    """Has a document with a mesh object that is closed at the end."""

    def setUp(self):
        self.doc = FreeCAD.newDocument("AnisoQuadTest")
        self.addCleanup(self.close)
        self.base = self.doc.addObject("Mesh::Feature", "Base")
        self.base.Mesh = square()

    def close(self):
        FreeCAD.closeDocument(self.doc.Name)
