"""How a source is kept in a document: one line of JSON, readable in the property editor and in the saved file."""

import json

from ..errors import MeshError
from ..source import Source, format_passes


def to_text(source):
    """The JSON of a Source or of a list of point ids; passes and sides only where they are not the default."""
    if not isinstance(source, Source):
        source = Source(source)
    content = {"vertices": source.vertices}
    if source.passes:
        content["passes"] = format_passes(source.passes)
    if source.sides != "both":
        content["sides"] = source.sides
    return json.dumps(content)


def from_text(text, passes, anisotropy):
    """The Source of such a line; passes, or else anisotropy, are for a line that has no passes. Raises MeshError."""
    try:
        content = json.loads(text)
        own = {key: content[key] for key in ("passes", "sides") if key in content}
        vertices = content["vertices"]
    except (ValueError, KeyError, TypeError):
        raise MeshError(f"Sources: can not read {text[:60]!r}", code="invalid_source") from None
    if "passes" not in own:
        own.update({"passes": passes} if passes else {"anisotropy": anisotropy})
    return Source(vertices, **own)
