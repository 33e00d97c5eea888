"""Line sources of anisotropy, and the notation of their passes."""

from . import _core
from .errors import MeshError


class Source:
    """A line along which anisotropic rows are built.

    vertices   -- 0-based ids of input points; neighbours share a mesh edge; closed when the first is also the last
    passes     -- merge ratios, first pass first: ints, or (ratio, rows) with rows an int or "auto"; or text: "4:6,2,2"
    anisotropy -- instead of passes: the maximum anisotropy, from which the core makes the paper's passes
    sides      -- "both", "left" or "right" of the line, seen along it with the surface normal up
    With neither passes nor anisotropy the line is kept as a feature, and no rows are built.
    """

    def __init__(self, vertices, passes=None, anisotropy=None, sides="both"):
        if passes is not None and anisotropy is not None:
            raise MeshError("Give either the passes or the anisotropy of a source, not both.", code="invalid_source")
        if sides not in _core.Sides.__members__:
            raise MeshError(f"The sides of a source are both, left or right, not {sides!r}.", code="invalid_source")
        try:
            self.vertices = [int(vertex) for vertex in vertices]
        except (TypeError, ValueError):
            raise MeshError("A source is a list of vertex ids.", code="invalid_source") from None
        if anisotropy is not None:
            self.passes = passes_for_anisotropy(anisotropy)
        else:
            self.passes = parse_passes(passes or [])
        self.sides = sides

    def __repr__(self):
        return f"Source({self.vertices!r}, passes={self.passes!r}, sides={self.sides!r})"

    def along(self, vertices):
        """The same passes and sides on another line."""
        return Source(vertices, passes=self.passes, sides=self.sides)

    def to_core(self):
        """The same for the compiled core."""
        passes = [_core.Pass(ratio, 0 if rows == "auto" else rows) for ratio, rows in self.passes]
        return _core.Source(self.vertices, passes, _core.Sides.__members__[self.sides])


def passes_for_anisotropy(anisotropy):
    """The paper's passes for a maximum anisotropy, as [(ratio, "auto"), ...]. Raises MeshError below 1."""
    if isinstance(anisotropy, bool) or int(anisotropy) != anisotropy:
        raise MeshError(f"The anisotropy is a whole number, not {anisotropy!r}.", code="invalid_option")
    return [(p.ratio, p.rows or "auto") for p in _core.passes_for_anisotropy(int(anisotropy))]


def parse_passes(passes):
    """Passes as [(ratio, rows or "auto"), ...] from such a list, a list of ratios, or text like "4, 2:6, 2".

    Raises MeshError when a ratio or a number of rows is not a whole number of at least 1.
    """
    if isinstance(passes, str):
        passes = [entry.split(":") for entry in passes.split(",")] if passes.strip() else []
    return [_parse_pass(entry) for entry in passes]


def format_passes(passes):
    """The text that parse_passes reads."""
    return ", ".join(f"{ratio}" if rows == "auto" else f"{ratio}:{rows}" for ratio, rows in parse_passes(passes))


def _parse_pass(entry):
    ratio, *rest = entry if isinstance(entry, (list, tuple)) else (entry,)
    if len(rest) > 1:
        raise MeshError(f"A pass is a ratio, or ratio:rows; found {entry!r}.", code="invalid_source")
    rows = rest[0] if rest else "auto"
    if isinstance(rows, str) and rows.strip() == "auto":
        rows = "auto"
    return _whole_number(ratio), rows if rows == "auto" else _whole_number(rows)


def _whole_number(value):
    try:
        number = int(value)
    except (TypeError, ValueError):
        number = 0
    if number < 1 or (not isinstance(value, str) and number != value):
        raise MeshError(f"A pass is a ratio, or ratio:rows, of whole numbers from 1 up; found {value!r}.", code="invalid_source")
    return number
