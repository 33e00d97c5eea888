"""Two commits of this repository side by side: medians of the benchmarks' times and of the process' peak memory.

usage: /usr/bin/python3 tests/benchmark/compare_builds.py BEFORE [AFTER] [--filter REGEX] [--runs 3]
AFTER is by default the work tree as it is. Commits are built in build/compare. The two take turns, so that what else the machine does
meets both alike.
"""

import argparse
import json
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FLAGS = ["-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O3 -g1 -DNDEBUG", "-DANISOQUAD_PYTHON=OFF", "-DANISOQUAD_TESTS=OFF"]


def build(commit):
    """The benchmark program of a commit, or of the work tree for None."""
    source = ROOT
    name = "worktree"
    if commit:
        name = subprocess.run(["git", "rev-parse", "--short", commit], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()
        source = ROOT / "build" / "compare" / name / "source"
        if not source.exists():
            source.mkdir(parents=True)
            archive = subprocess.Popen(["git", "archive", name], cwd=ROOT, stdout=subprocess.PIPE)
            subprocess.run(["tar", "x", "-C", source], stdin=archive.stdout, check=True)
            archive.wait()
    folder = ROOT / "build" / "compare" / name / "build"
    subprocess.run(["cmake", "-S", source, "-B", folder, *FLAGS], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "anisoquad_benchmark", "--parallel", str(os.cpu_count())], check=True,
                   stdout=subprocess.DEVNULL)
    return folder / "tests" / "benchmark" / "anisoquad_benchmark"


def run(program, pattern):
    """({benchmark: processor milliseconds}, peak memory in MB)."""
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        process = subprocess.Popen([program, f"--benchmark_filter={pattern}", f"--benchmark_out={file.name}", "--benchmark_out_format=json"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            raise RuntimeError(f"{program} failed")
        found = json.loads(Path(file.name).read_text())["benchmarks"]
    return {b["name"]: b["cpu_time"] for b in found if b.get("run_type") == "iteration"}, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before")
    parser.add_argument("after", nargs="?")
    parser.add_argument("--filter", default="/10000$|/8000/")
    parser.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    programs = [build(given.before), build(given.after)]
    runs = [[run(program, given.filter) for program in programs] for _ in range(given.runs)]
    print(f"{'benchmark':<40}{'before ms':>12}{'after ms':>12}{'after/before':>14}")
    for name in runs[0][1][0]:
        before, after = (statistics.median(r[k][0][name] for r in runs) if name in runs[0][k][0] else None for k in range(2))
        if before is None:
            print(f"{name:<40}{'–':>12}{after:>12.1f}")
            continue
        print(f"{name:<40}{before:>12.1f}{after:>12.1f}{after / before:>14.3f}")
    before, after = (statistics.median(r[k][1] for r in runs) for k in range(2))
    print(f"{'peak memory, MB':<40}{before:>12.1f}{after:>12.1f}{after / before:>14.3f}")


if __name__ == "__main__":
    main()
