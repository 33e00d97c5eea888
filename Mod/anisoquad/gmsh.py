"""Triangles of a CAD shape by the program Gmsh, where it is installed. No FreeCAD.

    points, triangles = triangulate("wing.step", size=20.0, angle=15.0)
"""

import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

from .errors import Cancelled, MeshError

STAGE = "triangulate"  # what progress() is told

SMALLEST = 2e-4  # of the shape's diagonal: an edge length below which the curvature, as at a cone's tip, need not refine

_POLL = 0.05  # seconds
_TRIANGLE = 2  # Gmsh's number of this type of element
_PERCENT = re.compile(r"\[ *(\d+)%\] Meshing (curve|surface)")

# Up to 4.8 the number of elements a turn was an option of its own.
_SCRIPT = """\
General.NumThreads = 1;
General.AbortOnError = 2;
Geometry.OCCParallel = 0;
Mesh.Algorithm = 6;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.MshFileVersion = 2.2;
Mesh.MeshSizeMin = {smallest!r};
Mesh.MeshSizeMax = {largest!r};
Mesh.MeshSizeFromCurvature = {per_turn!r};
If (GMSH_MAJOR_VERSION == 4 && GMSH_MINOR_VERSION < 9)
  Mesh.MinimumElementsPerTwoPi = {per_turn!r};
EndIf
{reading}Merge "{shape}";
Mesh 2;
Save "{mesh}";
"""

_SEW = "Geometry.OCCSewFaces = 1;\nGeometry.Tolerance = 1e-4;\n"  # the faces of an IGES file know nothing of each other


def has_gmsh():
    """True where the program is installed."""
    return shutil.which("gmsh") is not None


def triangulate(path, size=0.0, angle=30.0, smallest=0.0, progress=None):
    """(points (N,3) float64, triangles (M,3) int32) of a STEP, IGES or BREP file.

    size     -- largest edge length; 0: a tenth of the shape's diagonal, as Gmsh does
    angle    -- degrees that one edge may turn along a curve or surface; 0: any
    smallest -- edge length below which the curvature does not refine
    progress -- callable(stage: str, fraction: float); returning False ends Gmsh, and raises Cancelled
    Raises MeshError: "no_gmsh" where the program is missing, "face_not_meshable" where it fails.
    """
    program = shutil.which("gmsh")
    if program is None:
        raise MeshError("Gmsh is not installed: the program gmsh is missing (on Debian the package gmsh: apt-get install gmsh).", code="no_gmsh")
    with tempfile.TemporaryDirectory(prefix="anisoquad") as name:
        folder = Path(name)
        shape = (folder / "shape").with_suffix(Path(path).suffix.lower())
        try:
            shutil.copyfile(path, shape)
        except OSError as error:
            raise MeshError(f"{path}: {error.strerror}", code="unreadable_file") from None
        per_turn = 360.0 / angle if angle > 0.0 else 0.0
        script = _SCRIPT.format(smallest=float(smallest), largest=float(size) or 1e22, per_turn=per_turn,
                                shape=shape.name, mesh="mesh.msh", reading=_SEW if shape.suffix in (".iges", ".igs") else "")
        (folder / "script.geo").write_text(script, encoding="ascii")
        output = _run([program, "script.geo", "-0", "-v", "4", "-nt", "1"], folder, progress)
        mesh = folder / "mesh.msh"
        if not mesh.exists():
            raise MeshError(f"Gmsh can not triangulate the shape: {_reason(output)}", code="face_not_meshable")
        return _read(mesh.read_text(encoding="ascii"))


def triangulate_brep(text, **how):
    """The same of a text in BREP format, as a Part shape's exportBrepToString() gives."""
    with tempfile.TemporaryDirectory(prefix="anisoquad") as folder:
        path = Path(folder) / "shape.brep"
        path.write_text(text, encoding="utf-8")
        return triangulate(path, **how)


def _run(command, folder, progress):
    """What the program printed. It is killed when progress() says so, or whatever exception comes."""
    log = folder / "log"
    with log.open("wb") as file:
        try:
            process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT)
        except OSError as error:
            raise MeshError(f"Gmsh can not be run: {error}", code="no_gmsh") from None
        try:
            while process.poll() is None:
                if progress is not None and progress(STAGE, _fraction(log)) is False:
                    raise Cancelled("Meshing was cancelled.", code="cancelled")
                time.sleep(_POLL)
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()
    return log.read_text(encoding="utf-8", errors="replace")


def _fraction(log):
    """How much of the work is done, by what the program printed so far."""
    found = _PERCENT.findall(log.read_text(encoding="utf-8", errors="replace"))
    if not found:
        return 0.0
    percent, what = found[-1]
    return (0.1 if what == "curve" else 0.1 + 0.9 * int(percent) / 100.0) if what == "surface" else 0.1 * int(percent) / 100.0


def _reason(output):
    """The first error of what the program printed, on one line."""
    errors = [line.split(":", 1)[1].strip() for line in output.splitlines() if line.startswith("Error") and ":" in line]
    return errors[0] if errors else "it ended without a mesh."


def _read(text):
    """(points, triangles) of a .msh file of version 2.2; only the points that triangles have."""
    nodes = np.array(_section(text, "Nodes").split()[1:], float).reshape(-1, 4)
    lines = (line.split() for line in _section(text, "Elements").splitlines()[1:])
    corners = np.array([line[-3:] for line in lines if len(line) > 1 and int(line[1]) == _TRIANGLE], np.int64).reshape(-1, 3)
    ids, triangles = np.unique(corners, return_inverse=True)
    order = np.argsort(nodes[:, 0])
    rows = order[np.searchsorted(nodes[order, 0], ids)]
    return nodes[rows, 1:], triangles.reshape(-1, 3).astype(np.int32)


def _section(text, name):
    start, end = text.find(f"${name}\n"), text.find(f"$End{name}")
    return text[start + len(name) + 2 : end].strip() if 0 <= start < end else "0"
