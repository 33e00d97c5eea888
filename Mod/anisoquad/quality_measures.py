"""The measures that a quality view can show: how to compute, colour and rank each. No FreeCAD."""

from dataclasses import dataclass

import numpy as np

from . import quality

# From bad to good; the middle ones keep apart for colour-blind eyes by their brightness.
_SCALE = np.array([[0.70, 0.02, 0.15], [0.96, 0.65, 0.51], [0.97, 0.97, 0.80], [0.57, 0.77, 0.87], [0.13, 0.40, 0.67]])


@dataclass(frozen=True)
class Measure:
    """One measure of quads.

    title   -- what it is called
    compute -- (Q,) of a QuadMesh
    worst   -- "low", "high", or None where no value is bad
    bounds  -- (low, high) of the colours; None: of the values themselves
    """

    title: str
    compute: callable
    worst: str = None
    bounds: tuple = None

    def limits(self, values):
        """(low, high) of the colour scale."""
        if self.bounds:
            return self.bounds
        low, high = float(values.min()), float(values.max())
        return (low, high) if high > low else (low, low + 1.0)

    def colours(self, values):
        """(Q,3) float32 in 0…1: red where bad, blue where good."""
        low, high = self.limits(values)
        place = np.clip((values - low) / (high - low), 0.0, 1.0)
        return scale_colours(1.0 - place if self.worst == "high" else place)

    def worst_ids(self, values, count):
        """Ids of the worst quads, the worst first; none where no value is bad."""
        if self.worst is None:
            return np.empty(0, int)
        order = np.argsort(values if self.worst == "low" else -values, kind="stable")
        return order[:count]


def scale_colours(place):
    """(n,3) float32 colours of the scale at places in 0 (bad) … 1 (good)."""
    at = np.linspace(0.0, 1.0, len(_SCALE))
    return np.column_stack([np.interp(place, at, _SCALE[:, channel]) for channel in range(3)]).astype(np.float32)


MEASURES = {
    "scaled_jacobian": Measure("Scaled Jacobian", lambda mesh: quality.scaled_jacobian(mesh.points, mesh.quads), "low", (0.0, 1.0)),
    "aspect_ratio": Measure("Aspect ratio", lambda mesh: quality.aspect_ratio(mesh.points, mesh.quads), "high"),
    "skew": Measure("Skew", lambda mesh: quality.skew(mesh.points, mesh.quads), "high", (0.0, 1.0)),
    "size": Measure("Size", lambda mesh: quality.size(mesh.points, mesh.quads)),
    "row": Measure("Row", lambda mesh: mesh.row.astype(float)),
}
