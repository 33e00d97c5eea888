"""The report's figures as text."""


def quality_table(report):
    """A few lines: counts, rows per pass, quality, warnings."""
    reduction = report["reduction_percent"]
    lines = [
        f"triangles in        {report['triangles_in']:>9}",
        f"quads               {report['quads']:>9}" + (f"   ({reduction:.1f} % fewer elements)" if reduction > 0.0 else ""),
        f"nodes               {report['nodes']:>9}",
        f"triangles left      {report['triangles_left']:>9}",
        f"inverted            {report['inverted']:>9}",
        f"regular nodes     {report['regular_percent']:>11.1f} %",
        f"Hausdorff / diagonal {report['hausdorff_relative']:>8.1e}",
        "",
        f"{'':<16}{'min':>9}{'5 %':>9}{'mean':>9}{'95 %':>9}{'max':>9}",
    ]
    for name in ("scaled_jacobian", "aspect_ratio", "min_angle", "max_angle", "skew", "warpage"):
        values = report[name]
        figures = "".join(f"{values[key]:>9.3f}" for key in ("min", "p5", "mean", "p95", "max"))
        lines.append(f"{name.replace('_', ' '):<16}{figures}")
    if report["passes"]:
        lines += ["", "source  side   pass  ratio  rows  stopped because"]
    for entry in report["passes"]:
        lines.append(f"{entry['source'] + 1:>6}  {entry['side']:<5}  {entry['pass']:>4}  {entry['ratio']:>5}  "
                     f"{entry['rows']:>4}  {entry['stopped']}")
    lines += [f"warning: {warning}" for warning in report["warnings"]]
    return "\n".join(lines)
