"""Lines, points and facets drawn over the model, never picked themselves."""

import numpy as np
from pivy import coin


class LineNode:
    """A Coin node that draws polylines, points and facets over everything else.

    root -- the node, to be put into a scene
    """

    def __init__(self, colour, width, transparency=0.0):
        """colour -- three numbers in 0…1; width -- of lines, in pixels"""
        self.root = coin.SoAnnotation()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        material = coin.SoMaterial()
        material.diffuseColor.setValue(*colour)
        material.transparency.setValue(transparency)
        style = coin.SoDrawStyle()
        style.lineWidth = width
        style.pointSize = 2 * width
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.UNKNOWN_ORDERING
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoIndexedLineSet()
        self._points = coin.SoIndexedPointSet() if hasattr(coin, "SoIndexedPointSet") else None
        self._facets = coin.SoIndexedFaceSet()
        for node in (pick, light, material, style, hints, self._coordinates, self._lines, self._points, self._facets):
            if node is not None:
                self.root.addChild(node)
        self.clear()  # an index field begins with a zero in it

    def show(self, polylines, points=(), facets=()):
        """Draw lists of (x, y, z), single points, and polygons; replaces what was drawn."""
        coordinates, lines, dots, polygons = [], [], [], []
        for corners, indices in ((polylines, lines), (facets, polygons)):
            for polygon in corners:
                indices += [*range(len(coordinates), len(coordinates) + len(polygon)), -1]
                coordinates += polygon
        for point in points:
            dots.append(len(coordinates))
            coordinates.append(point)
        _set(self._coordinates.point, coordinates)
        _set(self._lines.coordIndex, lines)
        _set(self._facets.coordIndex, polygons)
        if self._points is not None:
            _set(self._points.coordIndex, dots)

    def show_segments(self, ends):
        """Draw many lines between two points each, (E,2,3); replaces what was drawn."""
        self.clear()
        count = len(ends)
        if count:
            self._coordinates.point.setValues(0, 2 * count, np.ascontiguousarray(ends, np.float32).reshape(-1, 3))
            indices = np.full((count, 3), -1, np.int32)
            indices[:, :2] = np.arange(2 * count).reshape(-1, 2)
            self._lines.coordIndex.setNum(3 * count)
            self._lines.coordIndex.setValues(0, 3 * count, indices.ravel())

    def clear(self):
        self.show([])


def _set(field, values):
    field.setNum(len(values))
    if values:
        field.setValues(0, len(values), values)
