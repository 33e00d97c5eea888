"""A run's figures as text for a panel."""

from ..compat import translate


def figures_text(obj):
    """A few lines of the quad mesh object's figures; empty while it holds no quads."""
    if not obj.Quads:
        return ""
    lines = [
        translate("QuadMeshPanel", "{quads} quads from {triangles} triangles ({reduction:.1f} % fewer elements)").format(
            quads=obj.Quads, triangles=obj.TrianglesIn, reduction=obj.Reduction),
        translate("QuadMeshPanel", "Scaled Jacobian: worst {worst:.3f}, mean {mean:.3f}; regular nodes: {regular:.1f} %").format(
            worst=obj.MinScaledJacobian, mean=obj.MeanScaledJacobian, regular=obj.RegularNodes),
        *obj.RowsPerPass,
        *(translate("QuadMeshPanel", "Warning: {}").format(warning) for warning in obj.Warnings),
    ]
    return "\n".join(lines)
