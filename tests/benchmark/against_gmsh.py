"""AnisoQuad and Gmsh on the same triangles, one after the other in one run: how many times faster, and how the time grows.

usage: PYTHONPATH=Mod /usr/bin/python3 tests/benchmark/against_gmsh.py [--sizes 10000 100000 1000000] [--runs 3] [--surface plane]
Needs Debian's gmsh, which makes the triangles and then merges their STL, classifies it at 45 degrees and recombines it by blossom on
one thread. Ratios are of processor time, medians over the runs: the whole processes, and our core against what Gmsh reports for
"Recombining 2D mesh". An odd number of triangles is no input for blossom: sizes are tried until it is even.
"""

import argparse
import json
import math
import os
import re
import statistics
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
AREA = {"plane": 1.0, "sphere": 4.0 * math.pi}
MODEL = {
    "plane": "Point(1)={{0,0,0,{h}}};Point(2)={{1,0,0,{h}}};Point(3)={{1,1,0,{h}}};Point(4)={{0,1,0,{h}}};"
             "Line(1)={{1,2}};Line(2)={{2,3}};Line(3)={{3,4}};Line(4)={{4,1}};Curve Loop(1)={{1,2,3,4}};Plane Surface(1)={{1}};",
    "sphere": 'SetFactory("OpenCASCADE");Sphere(1)={{0,0,0,1}};Mesh.MeshSizeMin={h};Mesh.MeshSizeMax={h};',
}
TIME_LIMIT = 3600  # seconds a process


def run(command, **options):
    """(standard output, processor seconds, peak memory in MB) of one process."""
    limited = ["timeout", str(TIME_LIMIT), *(str(part) for part in command)]
    process = subprocess.Popen(limited, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise RuntimeError(f"{command[0]} failed: {output[-400:]}")
    return output, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def count_triangles(stl):
    with stl.open("rb") as file:
        return struct.unpack("<I", file.read(84)[80:])[0]


def make_triangles(surface, wanted, folder):
    """Binary STL of about so many triangles, an even number."""
    stl = folder / f"{surface}{wanted}.stl"
    size = math.sqrt(4.0 * AREA[surface] / (math.sqrt(3.0) * wanted))
    for attempt in range(20):
        model = folder / "model.geo"
        model.write_text(MODEL[surface].format(h=size * (1.0 + 1e-3 * attempt)) + "Mesh.Binary=1;\n")
        run(["gmsh", model, "-2", "-format", "stl", "-o", stl, "-v", "1", "-nt", "1"])
        if count_triangles(stl) % 2 == 0:
            return stl
    raise RuntimeError("no even number of triangles")


def recombine_by_gmsh(stl, folder):
    """(seconds reported for the recombination, seconds of the process, MB)."""
    script = folder / "recombine.geo"
    script.write_text(f'General.NumThreads=1;Mesh.RecombinationAlgorithm=1;Mesh.Binary=1;Merge "{stl}";'
                      f'ClassifySurfaces{{45*Pi/180,1,1}};RecombineMesh;Save "{folder / "gmsh.msh"}";\n')
    output, seconds, memory = run(["gmsh", script, "-0", "-v", "4", "-nt", "1"])
    return float(re.findall(r"Done recombining 2D mesh \(Wall [\d.e+-]+s, CPU ([\d.e+-]+)s\)", output)[-1]), seconds, memory


def mesh_by_ourselves(stl, folder):
    """The same of the core and of the command-line tool."""
    report = folder / "report.json"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "Mod")}
    _, seconds, memory = run([sys.executable, "-m", "anisoquad", stl, folder / "out.obj", "--report", report], env=environment)
    figures = json.loads(report.read_text())
    return sum(stage["seconds"] for stage in figures["times"]), seconds, memory


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", type=int, nargs="+", default=[10000, 100000, 1000000])
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--surface", choices=sorted(AREA), nargs="+", default=["plane"])
    given = parser.parse_args()
    print(f"{'surface':<9}{'triangles':>10}{'core s':>9}{'whole s':>9}{'MB':>7}{'Gmsh recombines':>17}{'whole s':>9}{'MB':>7}"
          f"{'core faster':>13}{'whole faster':>14}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for surface in given.surface:
            points = []
            for size in given.sizes:
                stl = make_triangles(surface, size, folder)
                runs = [(mesh_by_ourselves(stl, folder), recombine_by_gmsh(stl, folder)) for _ in range(given.runs)]
                core, whole, memory = (statistics.median(ours[k] for ours, _ in runs) for k in range(3))
                recombines, gmsh_whole, gmsh_memory = (statistics.median(theirs[k] for _, theirs in runs) for k in range(3))
                points.append((math.log(count_triangles(stl)), math.log(core)))
                print(f"{surface:<9}{count_triangles(stl):>10}{core:>9.2f}{whole:>9.2f}{memory:>7.0f}{recombines:>17.2f}{gmsh_whole:>9.2f}"
                      f"{gmsh_memory:>7.0f}{recombines / core:>13.1f}{gmsh_whole / whole:>14.1f}", flush=True)
            if len(points) > 1:
                mean_x, mean_y = (sum(p[k] for p in points) / len(points) for k in range(2))
                slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)
                print(f"{surface}: the core's time grows as triangles^{slope:.3f}")


if __name__ == "__main__":
    main()
