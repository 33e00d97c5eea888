"""The core's words in a report, why rows ended and what it warns of, as they are shown: whole sentences, or parts that it joins."""

import re

from .translation import QT_TRANSLATE_NOOP

STOPPED = (
    QT_TRANSLATE_NOOP("Report", "as many rows as asked for"),
    QT_TRANSLATE_NOOP("Report", "another row or the boundary lies directly ahead"),
    QT_TRANSLATE_NOOP("Report", "the front turns too sharply for one more row"),
    QT_TRANSLATE_NOOP("Report", "the line at the row's end turns back to it"),
    QT_TRANSLATE_NOOP("Report", "the end column reaches a corner of the feature lines"),
    QT_TRANSLATE_NOOP("Report", "a column has become too slim"),
    QT_TRANSLATE_NOOP("Report", "the triangles ahead are too large for the length of the front's edges"),
    QT_TRANSLATE_NOOP("Report", "a boundary, a feature line or another row is too close ahead"),
    QT_TRANSLATE_NOOP("Report", "a quad of the row would be too distorted"),
    QT_TRANSLATE_NOOP("Report", "the triangles ahead could not be swapped into the row (column)"),
    QT_TRANSLATE_NOOP("Report", "the triangles ahead could not be swapped into the row (top)"),
    QT_TRANSLATE_NOOP("Report", "something lies inside the row"),
)
WARNINGS = (
    QT_TRANSLATE_NOOP("Report", "{} source nodes could not be merged"),
    QT_TRANSLATE_NOOP("Report", "{} patches have an odd boundary that nothing can make even"),
    QT_TRANSLATE_NOOP("Report", "{} triangles are left"),
    QT_TRANSLATE_NOOP("Report", "{} vertices of open edges lie at the place of another one; the surface is not joined there; repair joins it"),
    QT_TRANSLATE_NOOP("Report", "{} edges were collapsed because they are shorter than {} of the diagonal"),
    QT_TRANSLATE_NOOP("Report", "the edges of {} triangles were turned because some were thinner than {} of the diagonal"),
    QT_TRANSLATE_NOOP("Report", "{} quads are turned over by the surface to which they were brought"),
    QT_TRANSLATE_NOOP("Report", "{} patches were remeshed before: {} triangles became {}, edges up to {}"),
    QT_TRANSLATE_NOOP("Report", "{} of them have triangles too long and thin for quads ({} triangles)"),
    QT_TRANSLATE_NOOP("Report", "in {} of them the triangles' size changes too fast"),
    QT_TRANSLATE_NOOP("Report", "in {} of them the triangles turn too far from one to the next"),
    QT_TRANSLATE_NOOP("Report", "the shape's triangles are folded over at {} edges"),
    QT_TRANSLATE_NOOP("Report", "let Gmsh make them"),
    QT_TRANSLATE_NOOP("Report", "invalid faces of the shape were taken as they are"),
    QT_TRANSLATE_NOOP("Report", "the input was repaired"),
    QT_TRANSLATE_NOOP("Report", "{} facet without all vertices dropped"),
    QT_TRANSLATE_NOOP("Report", "{} facets without all vertices dropped"),
    QT_TRANSLATE_NOOP("Report", "{} facet without finite coordinates dropped"),
    QT_TRANSLATE_NOOP("Report", "{} facets without finite coordinates dropped"),
    QT_TRANSLATE_NOOP("Report", "{} facet without area removed"),
    QT_TRANSLATE_NOOP("Report", "{} facets without area removed"),
    QT_TRANSLATE_NOOP("Report", "{} facet doubled dropped"),
    QT_TRANSLATE_NOOP("Report", "{} facets doubled dropped"),
    QT_TRANSLATE_NOOP("Report", "{} vertex welded"),
    QT_TRANSLATE_NOOP("Report", "{} vertices welded"),
    QT_TRANSLATE_NOOP("Report", "{} edge cut apart"),
    QT_TRANSLATE_NOOP("Report", "{} edges cut apart"),
    QT_TRANSLATE_NOOP("Report", "{} facet turned"),
    QT_TRANSLATE_NOOP("Report", "{} facets turned"),
    QT_TRANSLATE_NOOP("Report", "{} vertex added"),
    QT_TRANSLATE_NOOP("Report", "{} vertices added"),
)
_TEXTS = frozenset(STOPPED + WARNINGS)

_NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")
_JOINTS = ("; ", ": ", ", ")


def shown(text, translate):
    """A text of the core in the user's language, its numbers put in. What is not known stays as it is.

    translate(context, text) -- Qt's
    """
    if (pattern := _NUMBER.sub("{}", text)) in _TEXTS:
        return translate("Report", pattern).format(*map(_short, _NUMBER.findall(text)))
    joint = next((joint for joint in _JOINTS if joint in text), None)
    return joint.join(shown(part, translate) for part in text.split(joint)) if joint else text


def _short(number):
    """The number without the digits that nobody reads."""
    return f"{float(number):.4g}" if "." in number else number
