"""A run's figures as text for a panel."""

import json

from ..compat import translate
from ..report_texts import shown


def figures_text(obj):
    """A few lines of the quad mesh object's figures; empty while it holds no quads."""
    if not obj.Quads:
        return ""
    if obj.Reduction > 0.0:
        counts = translate("QuadMeshPanel", "{quads} quads from {triangles} triangles ({reduction:.1f} % fewer elements)")
    else:  # a size was asked for, or few triangles show a CAD shape
        counts = translate("QuadMeshPanel", "{quads} quads from {triangles} triangles")
    report = json.loads(obj.Report)
    lines = [
        counts.format(quads=obj.Quads, triangles=obj.TrianglesIn, reduction=obj.Reduction),
        translate("QuadMeshPanel", "Scaled Jacobian: worst {worst:.3f}, mean {mean:.3f}; regular nodes: {regular:.1f} %").format(
            worst=obj.MinScaledJacobian, mean=obj.MeanScaledJacobian, regular=obj.RegularNodes),
        *_rows(report["passes"]),
        *(translate("QuadMeshPanel", "Warning: {}").format(shown(warning, translate)) for warning in report["warnings"]),
    ]
    return "\n".join(lines)


def _of_parts(counts):
    """The rows of the parts of a side: 13, 2/0/4, or 0–7 where there are many parts."""
    return "/".join(map(str, counts)) if len(counts) < 4 else f"{min(counts)}–{max(counts)}"


def _rows(passes):
    """One line a source and pass, with the rows of both sides; where a side has none at all, another one says why."""
    rows, why = {}, {}
    for entry in passes:
        key = entry["source"] + 1, entry["pass"], entry["ratio"]
        rows.setdefault(key, {}).setdefault(entry["side"], []).append(entry["rows"])
        why.setdefault((entry["source"] + 1, entry["side"]), []).append((entry["rows"], entry["stopped"]))
    for (source, pass_, ratio), sides in rows.items():
        counts = ", ".join(f"{_of_parts(counts)} {translate('SourcePanel', side)}" for side, counts in sides.items())
        yield translate("QuadMeshPanel", "Source {source}, pass {pass_} (1:{ratio}): rows {counts}").format(
            source=source, pass_=pass_, ratio=ratio, counts=counts)
    for (source, side), entries in why.items():
        if not any(count for count, _ in entries):
            yield translate("QuadMeshPanel", "Source {source} has no rows, {side}: {why}").format(
                source=source, side=translate("SourcePanel", side), why=shown(entries[0][1], translate))
