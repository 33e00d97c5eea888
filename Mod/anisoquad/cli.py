"""The command: python3 -m anisoquad IN OUT. Exit code 0: all quads and valid; 1: not so; 2: bad input, one line says what."""

import argparse
import json
import sys
from pathlib import Path

from . import __version__, cad, gmsh
from .errors import MeshError
from .io import read_and_split, read_triangles, writable, write_mesh
from .meshing import Options, quad_mesh
from .source import Source
from .summary import quality_table


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"{self.prog}: {message}\n")


def main(arguments=None):
    """Run the command; returns the exit code."""
    parser = _make_parser()
    given = parser.parse_args(arguments)
    try:
        if not writable(given.output):
            raise MeshError(f"{given.output}: can write .vtu, .inp, .msh, .su2 and .obj")
        options = _make_options(given)
        if Path(given.input).suffix.lower() in cad.FILES:
            mesh = _mesh_shape(given, options)
        else:
            if given.source_edges or given.smooth_angle or given.deflection or given.triangulator:
                raise MeshError("--source-edges, --smooth-angle, --deflection and --triangulator need a CAD file")
            points, triangles, split = read_and_split(given.input) if options.repair else (*read_triangles(given.input), 0)
            mesh = quad_mesh(points, triangles, _read_sources(given), options)
            if split:
                mesh.report["warnings"].insert(0, f"{split} facets with more than three corners were split into triangles")
        write_mesh(given.output, mesh)
        if given.report:
            _write_report(given.report, mesh.report)
    except MeshError as error:
        print(f"{parser.prog}: {' '.join(str(error).split())}", file=sys.stderr)
        return 2
    print(quality_table(mesh.report))
    if not mesh.valid:
        print(f"{parser.prog}: the mesh has triangles or inverted quads left", file=sys.stderr)
        return 1
    return 0


def _make_parser():
    parser = _Parser(prog="anisoquad", description="Mesh a triangulated surface or a CAD shape with quads, anisotropic along line sources.")
    parser.add_argument("input", metavar="IN", help=".stl, .obj, .off or .ply; CAD: .step, .iges or .brep")
    parser.add_argument("output", metavar="OUT", help=".vtu, .inp, .msh, .su2 or .obj")
    parser.add_argument("--source", metavar="FILE.json", help='{"leading_edge": [ids], "closed": false} or {"sources": [[ids], ...]}')
    parser.add_argument("--source-edges", metavar="N[,N...]", action="append",
                        help="of a CAD file: numbers of edges that follow each other, from 1, as source; may be given several times")
    parser.add_argument("--chain", action="store_true", help="with --source-edges: and the edges that go on from these tangentially")
    parser.add_argument("--smooth-angle", metavar="DEG", type=float, default=0.0,
                        help="of a CAD file: faces whose normals differ by less where they meet are one patch (default: each is one)")
    parser.add_argument("--deflection", metavar="X", type=float, default=0.0,
                        help="of a CAD file: of the triangles that are remeshed, off the shape (default: 2e-4 of its diagonal)")
    parser.add_argument("--triangulator", choices=("opencascade", "gmsh"),
                        help="of a CAD file: what makes the triangles; gmsh, where it is installed, takes --size and --curvature-angle (default: opencascade)")
    passes = parser.add_mutually_exclusive_group()
    passes.add_argument("--passes", metavar="R[:ROWS],...", help="merge ratio of each pass, e.g. 4,2,2")
    passes.add_argument("--anisotropy", metavar="N", type=int, help="maximum anisotropy instead of passes")
    parser.add_argument("--report", metavar="R.json", help="write the figures of the run")
    parser.add_argument("--version", action="version", version=f"anisoquad {__version__}")
    defaults = Options()
    for name, doc in Options.fields.items():
        default = getattr(defaults, name)
        flag = "--" + name.replace("_", "-")
        doc = f"{doc} (default: {default})".replace("%", "%%")
        if isinstance(default, bool):
            parser.add_argument(flag, action=argparse.BooleanOptionalAction, default=None, help=doc)
        elif isinstance(default, (int, float)):
            parser.add_argument(flag, type=type(default), metavar="X", help=doc)
    return parser


def _make_options(given):
    values = {name: getattr(given, name, None) for name in Options.fields}
    return Options(**{name: value for name, value in values.items() if value is not None})


def _mesh_shape(given, options):
    """The QuadMesh of a CAD file, its nodes on the shape."""
    shape = cad.CadShape.from_file(given.input, check=not options.repair)
    points, triangles = _triangulate(shape, given, options)
    surface = cad.CadSurface(shape, points, triangles, join_smooth=given.smooth_angle)
    sources = _read_sources(given)
    for text in given.source_edges or []:
        edges = [edge.strip() for edge in text.split(",")]
        if given.chain:
            edges = shape.tangent_chain(edges[0])
        sources.append(Source(surface.path(edges), passes=given.passes, anisotropy=given.anisotropy))
    return quad_mesh(points, triangles, sources, options, surface=surface)


def _triangulate(shape, given, options):
    if given.triangulator != "gmsh":
        return shape.triangulate(given.deflection)
    if given.deflection:
        raise MeshError("--deflection is for --triangulator opencascade")
    return gmsh.triangulate(given.input, size=options.size, angle=options.curvature_angle, smallest=gmsh.SMALLEST * shape.diagonal)


def _read_sources(given):
    if given.source is None:
        if (given.passes or given.anisotropy is not None) and not given.source_edges:
            raise MeshError("--passes and --anisotropy need a --source or --source-edges")
        return []
    try:
        content = json.loads(Path(given.source).read_text(encoding="utf-8"))
    except OSError as error:
        raise MeshError(f"{given.source}: {error.strerror}") from None
    except ValueError as error:
        raise MeshError(f"{given.source}: not a JSON file ({error})") from None
    if isinstance(content, dict) and isinstance(content.get("sources"), list):
        lines = content["sources"]
    elif isinstance(content, dict) and "leading_edge" in content:
        lines = [content["leading_edge"]]
        if content.get("closed") and lines[0][:1] != lines[0][-1:]:
            lines[0] = lines[0] + lines[0][:1]
    else:
        raise MeshError(f'{given.source}: holds neither "leading_edge" nor "sources"')
    if not all(isinstance(line, list) and all(type(vertex) is int for vertex in line) for line in lines):
        raise MeshError(f"{given.source}: a source is a list of vertex ids")
    return [Source(line, passes=given.passes, anisotropy=given.anisotropy) for line in lines]


def _write_report(path, report):
    try:
        Path(path).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise MeshError(f"{path}: {error.strerror}") from None
