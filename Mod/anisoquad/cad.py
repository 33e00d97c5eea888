"""The CAD shape behind the triangles, through OpenCASCADE. No FreeCAD.

    shape = CadShape.from_file("wing.step")
    points, triangles = shape.triangulate()
    surface = CadSurface(shape, points, triangles)
    mesh = quad_mesh(points, triangles, [Source(surface.path(["Edge3"]), anisotropy=16)], Options(size=10.0), surface=surface)
    mesh.cad_face                           # the face of every quad

Faces and edges have FreeCAD's names: Face1 …, Edge1 …
"""

import numpy as np

from .errors import MeshError
from .meshing import checked_points, checked_triangles

FILES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")

_SMOOTH_ANGLE = 5.0  # degrees between the normals of faces that are joined into one patch
_CHAIN_ANGLE = 15.0  # degrees between edges that follow each other


def _core():
    try:
        from . import _cad
    except ImportError as error:
        raise MeshError("AnisoQuad's part for CAD shapes is missing: it needs OpenCASCADE, and `make build` in the add-on's folder "
                        f"({error})", code="no_cad") from None
    return _cad


def has_cad():
    """True where the part for CAD shapes was built, and finds OpenCASCADE."""
    try:
        _core()
    except MeshError:
        return False
    return True


class CadShape:
    """A CAD shape.

    face_count, edge_count -- numbers of faces and edges
    diagonal -- of its bounding box
    made -- the core's Triangulation of the last triangulate(), None before: CadSurface takes the faces of its triangles from it
    """

    def __init__(self, core):
        self.core = core
        self.name, self.diagonal = core.name, core.diagonal
        self.face_count, self.edge_count = core.face_count, core.edge_count
        self.made = None

    @classmethod
    def from_file(cls, path, check=True):
        """Read a STEP, IGES or BREP file. Raises MeshError ("invalid_shape") for what can not be read, is empty or invalid.

        check -- reject a shape with faces in which OpenCASCADE finds errors
        """
        return cls(_core().CadShape.from_file(str(path), str(path), check))

    @classmethod
    def from_brep(cls, text, name="The shape", check=True):
        """The shape of a text in BREP format, as a Part shape's exportBrepToString() gives. name -- for messages."""
        return cls(_core().CadShape.from_brep(text, name, check))

    def triangulate(self, deflection=0.0, angle=8.0):
        """(points (N,3), triangles (M,3)) by BRepMesh: long and thin triangles, for quad_mesh(surface=…) to prepare.

        deflection -- largest distance from the shape; 0: a five-thousandth of its diagonal
        angle      -- degrees between neighbours along a curve or surface
        Raises MeshError ("face_not_meshable") with the faces on which there are none.
        """
        self.made = self.core.triangulate(deflection, angle)
        return self.made.points, self.made.triangles

    def invalid_faces(self):
        """Names of the faces in which OpenCASCADE finds errors."""
        return [f"Face{index + 1}" for index in self.core.invalid_faces()]

    def check(self):
        """Raise MeshError ("invalid_shape") with the faces in which OpenCASCADE finds errors."""
        self.core.check()

    def tangent_chain(self, edge, angle=_CHAIN_ANGLE):
        """Names of the edges that go on from an edge tangentially, in order, e.g. ["Edge7", "Edge3"].

        angle -- degrees by which neighbours may turn
        """
        return [f"Edge{index + 1}" for index, _ in self.core.tangent_chain(_index(edge, "Edge", self.edge_count), angle)]


class CadSurface:
    """A shape linked to a triangulation of it: the surface onto which quad_mesh() puts its nodes.

    shape, points, triangles -- what belongs together; points of single precision, or off the shape by less than an edge's bow,
                                will do. What the shape's last triangulate() gave needs no search for its faces and edges
    join_smooth -- faces that go on into each other smoothly are one patch; True, or the degrees that their normals may differ
    self.points -- the points again, each put onto the shape
    Raises MeshError: "shape_mismatch" with the vertices or CAD edges where they do not belong together, "face_not_meshable" with the
    faces that have no triangles, and what quad_mesh() raises for bad triangles.
    """

    def __init__(self, shape, points, triangles, join_smooth=False):
        angle = _SMOOTH_ANGLE if join_smooth is True else float(join_smooth)
        self.shape = shape
        self.triangles = checked_triangles(triangles)
        self.core = _core().CadSurface(shape.core, checked_points(points), self.triangles, angle, shape.made)
        self.points = self.core.points
        self.facet_face = self.core.facet_face
        self.feature_edges = self.core.feature_edges()

    def entities(self):
        """For each point what it lies on: "Vertex2", "Edge5" or "Face1"."""
        return [f"{kind.capitalize()}{index + 1}" if index >= 0 else "" for kind, index in self.core.entities]

    def count_folds(self):
        """Number of edges within the shape's faces at which the triangles face away from each other: a poor tessellation."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        sides = np.sort(self.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        order = np.lexsort(sides.T)
        sides, facet = sides[order], np.repeat(np.arange(len(self.triangles)), 3)[order]
        first = np.flatnonzero((sides[1:] == sides[:-1]).all(axis=1))
        one, other = facet[first], facet[first + 1]
        inside = self.facet_face[one] == self.facet_face[other]
        return int(np.count_nonzero(inside & (np.einsum("ij,ij->i", normals[one], normals[other]) < 0.0)))

    def path(self, edges, reverse=False):
        """Point ids along CAD edges that follow each other, closed when the first is also the last.

        edges   -- names like "Edge3", or numbers from 1, in any order; or one of them
        reverse -- the other way round
        Raises MeshError ("invalid_source") where they are not one line, or the triangles do not follow them.
        """
        edges = [edges] if isinstance(edges, (str, int)) else edges
        return self.core.path([_index(edge, "Edge", self.shape.edge_count) for edge in edges], reverse)

    def entities_of(self, result):
        """{"cad_face": …, "cad_edge": …} of the core's result, see QuadMesh."""
        edges = [self.core.edge_of(a, b) for a, b in result["line_edge_input"].tolist()]
        return {"cad_face": self.facet_face[result["quad_facet"]], "cad_edge": np.array(edges, np.int32)}

    def project(self, points, facets, edges):
        """(N,3) points put onto the surface.

        facets -- (N,) triangles near them; edges -- (N,2) edges of the triangulation near them, whose CAD edge they shall be on
                  if there is one, else (-1, -1)
        """
        return self.core.project(checked_points(points), np.asarray(facets).tolist(), np.asarray(edges).tolist())


def _index(name, kind, count):
    """0-based index of "Edge3", "3" or 3. Raises MeshError when there is no such one."""
    text = str(name)
    digits = text[len(kind) :] if text.startswith(kind) else text
    if not digits.isdecimal() or not 1 <= int(digits) <= count:
        raise MeshError(f"The shape has no {kind.lower()} {text}; it has {kind}1 to {kind}{count}.", code="invalid_source")
    return int(digits) - 1
