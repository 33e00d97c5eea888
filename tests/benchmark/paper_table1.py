"""The paper's Table 1 on the delta wing: how many quads are left at each maximum anisotropy.

usage: PYTHONPATH=Mod /usr/bin/python3 tests/benchmark/paper_table1.py [WING]
Ends with 1 when a limit is not met. WING: wing_delta (default) or wing_swept; the limits are for wing_delta.
"""

import sys

import numpy as np
import wing

import anisoquad

PAPER = {1: 100, 2: 73, 3: 62, 4: 54, 5: 49, 6: 45, 8: 42, 16: 37}  # percent of the quads at 1:1
SCALED_JACOBIAN_LIMIT = 0.3  # of the quads that do not fill a corner between feature lines whose angle alone keeps them below it
SIZE_RATIO_LIMIT = 2.5  # area of neighbouring quads across the rows' end
FIRST_ROW_LIMIT = 10.0  # aspect ratio at mid source, of 1:16


def measure(name, anisotropy):
    """(mesh, aspect ratio of the first row at mid source, [mean aspect ratio of each row])."""
    points, triangles, line = wing.read(name)
    mesh = anisoquad.quad_mesh(points, triangles, [anisoquad.Source(line, anisotropy=anisotropy)])
    aspect = wing.aspect_ratios(mesh)
    along = wing.position_along(mesh, points[line[0]], points[line[-1]])
    middle = (mesh.row == 1) & (along > 0.35) & (along < 0.65)
    rows = [aspect[mesh.row == row].mean() for row in range(1, mesh.row.max() + 1)]
    return mesh, aspect[middle].mean() if middle.any() else 1.0, rows


def main(name="wing_delta"):
    print(f"{name}\n anisotropy   quads   % of 1:1   paper   triangles left   inverted   SJ min   elsewhere   SJ mean   first row   rows   row end p95   max")
    failures = []
    isotropic = None
    for anisotropy, paper in PAPER.items():
        mesh, first_row, rows = measure(name, anisotropy)
        report = mesh.report
        isotropic = isotropic or report["quads"]
        percent = 100.0 * report["quads"] / isotropic
        jacobian = report["scaled_jacobian"]
        elsewhere = report["scaled_jacobian_min_elsewhere"]
        print(f"       1:{anisotropy:<3}{report['quads']:>8}{percent:>11.1f}{paper:>8}{report['triangles_left']:>17}"
              f"{report['inverted']:>11}{jacobian['min']:>9.3f}{elsewhere:>12.3f}{jacobian['mean']:>10.3f}{first_row:>12.1f}{len(rows):>7}"
              f"{report['neighbour_area_ratio_p95']:>14.2f}{report['neighbour_area_ratio_max']:>6.2f}")
        checks = {
            f"more than {paper} % of its own 1:1": percent <= paper,
            "triangles or inverted quads left": mesh.valid,
            f"scaled Jacobian below {SCALED_JACOBIAN_LIMIT}": elsewhere >= SCALED_JACOBIAN_LIMIT,
            f"size across the rows' end differs by more than {SIZE_RATIO_LIMIT}": report["neighbour_area_ratio_max"] <= SIZE_RATIO_LIMIT,
        }
        if anisotropy == 16:
            checks[f"first row's aspect ratio below {FIRST_ROW_LIMIT}"] = first_row >= FIRST_ROW_LIMIT
            checks["aspect ratio does not fall with the row"] = bool(np.all(np.diff(rows) <= 0))
        failures += [f"1:{anisotropy}: {what}" for what, met in checks.items() if not met]
    print(f"\nSJ elsewhere: without the quads in the feature lines' corners, of which the sharpest has {report['sharpest_corner']:.1f} degrees: "
          f"no quad there can be above {report['scaled_jacobian_limit']:.3f}")
    print("mean aspect ratio per row at 1:16, from the source: " + " ".join(f"{value:.1f}" for value in rows))
    for entry in report["passes"]:
        print(f"source {entry['source'] + 1}, {entry['side']}, pass {entry['pass']} (1:{entry['ratio']}): "
              f"{entry['rows']} rows; {entry['stopped']}")
    if name == "wing_delta":
        for failure in failures:
            print(f"not met: {failure}")
        return 1 if failures else 0
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
