"""Part shapes for the tests."""

import sys
from pathlib import Path

import FreeCAD

sys.path.append(str(Path(__file__).resolve().parents[1] / "benchmark"))


def loft_wing(doc, span=1000.0, chord=500.0):
    """A Part::Loft of two airfoil wires; the tip's wire is `WingTip`."""
    from cad_shapes import section

    wires = []
    for name, place in (("WingRoot", 0.0), ("WingTip", span)):
        wire = doc.addObject("Part::Feature", name)
        wire.Shape = section(chord if place == 0.0 else 0.6 * chord, (0, 0, 0))
        wire.Placement.Base = FreeCAD.Vector(0.25 * chord + 0.2 * place, place, 0)
        wires.append(wire)
    wing = doc.addObject("Part::Loft", "Wing")
    wing.Sections = wires
    wing.Solid = True
    wing.Ruled = True
    doc.recompute()
    return wing


def edge_between(shape, *ends):
    """Name of the edge with these ends (vectors, to a hundredth of a millimetre)."""
    for index, edge in enumerate(shape.Edges):
        points = [vertex.Point for vertex in edge.Vertexes]
        if len(points) == 2 and all(any(point.distanceToPoint(end) < 1e-2 for point in points) for end in ends):
            return f"Edge{index + 1}"
    raise AssertionError("there is no such edge")


def leading_edge(wing):
    """Name of a loft wing's leading edge."""
    front = [min((vertex.Point for vertex in section.Shape.Vertexes), key=lambda point: point.x) for section in wing.Sections]
    return edge_between(wing.Shape, *front)


def largest_distance(shape, fem_mesh):
    """Of the nodes from the shape, by OpenCASCADE's own measure."""
    import Part

    return max(shape.distToShape(Part.Vertex(*node))[0] for node in fem_mesh.Nodes.values())
