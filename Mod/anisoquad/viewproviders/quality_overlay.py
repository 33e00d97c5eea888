"""A quad mesh in the view with one colour a quad, and its legend."""

import numpy as np
from pivy import coin

from ..quality_measures import scale_colours

_STEPS = 5  # of the legend


class QualityOverlay:
    """Draws a QuadMesh in a view. 100,000 quads take some tenths of a second."""

    def __init__(self, view, mesh):
        self._scene = view.getSceneGraph()
        self._mesh = mesh
        self._root = coin.SoSeparator()
        self._material = coin.SoMaterial()
        self._legend = coin.SoSeparator()
        self._marked = coin.SoIndexedFaceSet()
        self._fill()
        self._scene.addChild(self._root)

    def _fill(self):
        coordinates = coin.SoCoordinate3()
        points = np.ascontiguousarray(self._mesh.points, np.float32)
        coordinates.point.setValues(0, len(points), points)
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        faces = coin.SoIndexedFaceSet()
        _set_indices(faces.coordIndex, self._mesh.quads)
        offset = coin.SoPolygonOffset()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR  # so that the colours are those of the legend
        for node in (light, hints, coordinates, offset, self._material, binding, faces, self._edges(), self._mark_node(), self._legend):
            self._root.addChild(node)

    def _edges(self):
        """The mesh's edges as dark lines."""
        node = coin.SoSeparator()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        colour = coin.SoBaseColor()
        colour.rgb.setValue(0.15, 0.15, 0.15)
        whole = coin.SoMaterialBinding()
        whole.value = coin.SoMaterialBinding.OVERALL
        lines = coin.SoIndexedLineSet()
        _set_indices(lines.coordIndex, np.column_stack([self._mesh.quads, self._mesh.quads[:, :1]]))
        for child in (light, colour, whole, lines):
            node.addChild(child)
        return node

    def _mark_node(self):
        node = coin.SoAnnotation()
        colour = coin.SoBaseColor()
        colour.rgb.setValue(1.0, 0.0, 1.0)
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        whole = coin.SoMaterialBinding()
        whole.value = coin.SoMaterialBinding.OVERALL
        style = coin.SoDrawStyle()
        style.style = coin.SoDrawStyle.LINES
        style.lineWidth = 3
        for child in (light, colour, whole, style, self._marked):
            node.addChild(child)
        return node

    def show(self, measure, values):
        """Colour by a Measure's values (Q,)."""
        colours = np.ascontiguousarray(measure.colours(values), np.float32)
        self._material.diffuseColor.setNum(len(colours))
        self._material.diffuseColor.setValues(0, len(colours), colours)
        self._show_legend(measure, *measure.limits(values))

    def mark(self, ids):
        """Draw the outline of these quads over everything."""
        _set_indices(self._marked.coordIndex, self._mesh.quads[np.asarray(ids, int)])

    def remove(self):
        """Take it out of the view. May be called again."""
        if self._scene.findChild(self._root) >= 0:
            self._scene.removeChild(self._root)

    def _show_legend(self, measure, low, high):
        """A bar with numbers at the left of the view, whatever the camera."""
        self._legend.removeAllChildren()
        camera = coin.SoOrthographicCamera()
        camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        camera.position.setValue(0.5, 0.5, 5.0)
        camera.height = 1.0
        camera.aspectRatio = 1.0
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        annotation = coin.SoAnnotation()
        for node in (camera, light, coin.SoResetTransform()):
            annotation.addChild(node)
        place = np.linspace(0.0, 1.0, _STEPS)
        good = 1.0 - place if measure.worst == "high" else place
        annotation.addChild(_bar(np.ones((2, 3)), (0.01, 0.19), (0.27, 0.77)))
        annotation.addChild(_bar(scale_colours(good), (0.02, 0.045), (0.3, 0.7)))
        for at in place:
            annotation.addChild(_text(f"{low + at * (high - low):.3g}", 0.055, 0.3 + 0.4 * at - 0.008))
        annotation.addChild(_text(measure.title, 0.02, 0.73))
        self._legend.addChild(annotation)


def _set_indices(field, polygons):
    """Polygons (n,k) of point ids into an index field."""
    indices = np.column_stack([polygons, np.full(len(polygons), -1)]).astype(np.int32).ravel()
    field.setNum(len(indices))
    if len(indices):
        field.setValues(0, len(indices), indices)


def _bar(colours, across, up):
    """A rectangle of the view, (from, to) across and up in parts of it, whose colours run from the bottom up."""
    node = coin.SoSeparator()
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    material = coin.SoMaterial()
    coordinates = coin.SoCoordinate3()
    strip = coin.SoQuadMesh()
    strip.verticesPerRow = 2
    strip.verticesPerColumn = len(colours)
    for index, colour in enumerate(colours.tolist()):
        height = up[0] + (up[1] - up[0]) * index / (len(colours) - 1)
        for side, x in enumerate(across):
            material.diffuseColor.set1Value(2 * index + side, *colour)
            coordinates.point.set1Value(2 * index + side, x, height, 0.0)
    for child in (material, binding, coordinates, strip):
        node.addChild(child)
    return node


def _text(text, x, y):
    node = coin.SoSeparator()
    colour = coin.SoBaseColor()
    colour.rgb.setValue(0.1, 0.1, 0.1)
    place = coin.SoTranslation()
    place.translation.setValue(x, y, 0.1)
    font = coin.SoFont()
    font.size = 14
    words = coin.SoText2()
    words.string = text
    for child in (colour, place, font, words):
        node.addChild(child)
    return node
