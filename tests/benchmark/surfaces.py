"""Every surface that is at hand, from its triangles alone and with its leading edge at 1:8, as one table.

usage: PYTHONPATH=Mod /usr/bin/python3 tests/benchmark/surfaces.py [NAME ...] [--sources | --no-sources] [--keep FOLDER]
Surfaces: tests/data, and the folder ANISOQUAD_SURFACES (default ../shared/data) with all below it that has no "bad" in its path.
Judge: the script ANISOQUAD_JUDGE (default ../shared/evaluate.py), called as `JUDGE MESH REFERENCE --summary`; without it the mesher's
own report is shown, and marked so. Ends with 1 when a valid surface gives triangles, inverted quads or loses its features.
"""

import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SURFACES = Path(os.environ.get("ANISOQUAD_SURFACES", ROOT.parent / "shared" / "data"))
JUDGE = Path(os.environ.get("ANISOQUAD_JUDGE", ROOT.parent / "shared" / "evaluate.py"))
PEERS = Path(__file__).with_name("peers.csv")
TIME_LIMIT = 900  # seconds a surface

AIRCRAFT_DISTANCE = 2e-3  # Hausdorff distance over the diagonal that is allowed, where a surface has a leading edge
OTHER_DISTANCE = 4e-3
FEATURES = 0.999  # of the input's feature length within 1e-4 of the diagonal of a mesh edge

HEADER = (f"{'surface':<34}{'triangles':>10}{'quads':>8}{'tri left':>9}{'inverted':>9}{'regular %':>10}"
          f"{'SJ min':>8}{'p5':>6}{'mean':>7}{'Hausdorff':>11}{'features %':>11}{'s':>8}")


def find_surfaces(names):
    """[(name, OFF file, JSON file of its leading edge or None)], each name once."""
    found = {}
    for folder in (ROOT / "tests" / "data", SURFACES):
        for file in sorted(folder.rglob("*.off")) if folder.is_dir() else []:
            if "bad" in file.relative_to(folder).parts or "fuzz" in file.parts or (names and file.stem not in names):
                continue
            found.setdefault(file.stem, (file.stem, file, leading_edge_of(file)))
    return [found[name] for name in sorted(found)]


def leading_edge_of(file):
    for candidate in (file.with_suffix(".le.json"), file.with_suffix(".json")):
        if candidate.exists() and "leading_edge" in json.loads(candidate.read_text()):
            return candidate
    return None


def mesh(file, output, source=None):
    """(report, seconds of the whole process)."""
    report = output.with_suffix(".report.json")
    for old in (output, report):
        old.unlink(missing_ok=True)
    command = [sys.executable, "-m", "anisoquad", file, output, "--report", report]
    if source:
        command += ["--source", source, "--anisotropy", "8"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "Mod")}
    start = time.monotonic()
    done = subprocess.run([str(part) for part in command], env=environment, capture_output=True, text=True, timeout=TIME_LIMIT)
    seconds = time.monotonic() - start
    if not report.exists():
        raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr.strip() else f"exit code {done.returncode}")
    return json.loads(report.read_text()), seconds


def judge(output, file, report):
    """The figures of a row: the judge's, or our own where there is none."""
    if JUDGE.exists():
        done = subprocess.run(["/usr/bin/python3", str(JUDGE), str(output), str(file), "--summary"], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip().splitlines()[-1])
        found = json.loads(done.stdout)
        return {"quads": found["quads"], "left": found["tris"], "inverted": found["inv"], "regular": 100 - found["irr_pct"],
                "min": found["sj_min"], "p5": found["sj_p5"], "mean": found["sj_mean"], "hausdorff": found["h"],
                "features": found.get("feat4")}
    jacobian = report["scaled_jacobian"]
    return {"quads": report["quads"], "left": report["triangles_left"], "inverted": report["inverted"],
            "regular": report["regular_percent"], "min": jacobian["min"], "p5": jacobian["p5"], "mean": jacobian["mean"],
            "hausdorff": report["hausdorff_relative"], "features": None}


def row(name, triangles, figures, seconds):
    features = "–" if figures["features"] is None else f"{100 * figures['features']:.2f}"
    return (f"{name:<34}{triangles:>10}{figures['quads']:>8}{figures['left']:>9}{figures['inverted']:>9}{figures['regular']:>10.2f}"
            f"{figures['min']:>8.3f}{figures['p5']:>6.2f}{figures['mean']:>7.3f}{figures['hausdorff']:>11.1e}{features:>11}{seconds:>8.2f}")


def failures_of(figures, is_aircraft):
    limit = AIRCRAFT_DISTANCE if is_aircraft else OTHER_DISTANCE
    checks = {"triangles left": figures["left"] == 0, "inverted quads": figures["inverted"] == 0,
              f"Hausdorff distance above {limit}": figures["hausdorff"] <= limit,
              "features lost": figures["features"] is None or figures["features"] >= FEATURES}
    return [what for what, met in checks.items() if not met]


def peers_of(name):
    if not PEERS.exists():
        return []
    with PEERS.open(encoding="utf-8") as file:
        return [line for line in csv.DictReader(file) if line["surface"] == name]


def show_peer(peer):
    label = "  " + peer["peer"]
    print(f"{label:<44}{peer['quads']:>8}{peer['left']:>9}{peer['inverted']:>9}{peer['regular']:>10}{peer['min']:>8}{peer['p5']:>6}"
          f"{peer['mean']:>7}{peer['hausdorff']:>11}{peer['features']:>11}{peer['seconds']:>8}")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--sources", action=argparse.BooleanOptionalAction, default=None, help="only with, or only without leading edges")
    parser.add_argument("--keep", type=Path, help="folder for the meshes and reports")
    given = parser.parse_args(arguments)
    folder = given.keep or Path(tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    print(f"judged by {JUDGE.name if JUDGE.exists() else 'the own report'}\n{HEADER}")
    failures = []
    for name, file, source in find_surfaces(given.names):
        runs = [(name, None)] if given.sources is not True else []
        if source and given.sources is not False:
            runs.append((f"{name} 1:8", source))
        for label, used in runs:
            output = folder / f"{label.replace(' 1:8', '_8')}.vtu"
            try:
                report, seconds = mesh(file, output, used)
                figures = judge(output, file, report)
            except (RuntimeError, subprocess.TimeoutExpired) as error:
                print(f"{label:<34} {error}", flush=True)
                failures.append(f"{label}: no mesh")
                continue
            print(row(label, report["triangles_in"], figures, seconds), flush=True)
            failures += [f"{label}: {what}" for what in failures_of(figures, source is not None)]
        if given.sources is not True:
            for peer in peers_of(name):
                show_peer(peer)
    for failure in failures:
        print(f"not met: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
