"""Shell analysis of a wing by FEM's own tools: isotropic quads against 1:16 rows along the leading edge.

freecadcmd resources/examples/wing_shell/wing_shell.py
The wing is a closed shell of aluminium, 1 m of half span, 2 mm thick, held at its root, with pressure on its upper side. CalculiX
runs through FEM's ccxtools. Prints elements and tip displacement of both meshes side by side; the documents are kept in
build/wing_shell.
"""

import json
import sys
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
OUT = ROOT / "build" / "wing_shell"
SCALE = 1000.0  # the data's unit is a metre, FreeCAD's a millimetre
THICKNESS, PRESSURE = 2.0, 0.002  # mm, MPa
ALUMINIUM = {"Name": "Aluminium", "YoungsModulus": "70000 MPa", "PoissonRatio": "0.33", "Density": "2700 kg/m^3"}
MESHES = (("1:1", 1), ("1:16", 16))


def wing_mesh():
    """(Mesh.Mesh in millimetres, point ids of its leading edge)"""
    import FreeCAD
    import Mesh

    mesh = Mesh.Mesh(str(ROOT / "tests" / "data" / "wing_delta.off"))
    matrix = FreeCAD.Matrix()
    matrix.scale(SCALE, SCALE, SCALE)
    mesh.transform(matrix)
    return mesh, json.loads((ROOT / "tests" / "data" / "wing_delta.json").read_text())["leading_edge"]


def make_model(doc, anisotropy):
    """The quad mesh of the wing in a document, in second order. Returns the quad mesh object."""
    import anisoquad

    base = doc.addObject("Mesh::Feature", "Wing")
    base.Mesh, leading_edge = wing_mesh()
    sources = [anisoquad.Source(leading_edge, anisotropy=anisotropy)]
    quads = anisoquad.make_quad_mesh(doc, base=base, sources=sources, element_order=2)
    doc.recompute()
    if not quads.isValid():
        raise RuntimeError(quads.getStatusString())
    return quads


def add_analysis(doc, quads):
    """Analysis, solver, material, thickness, fixed root, pressure on the upper side. Returns (analysis, solver)."""
    import FreeCAD
    import ObjectsFem

    analysis = ObjectsFem.makeAnalysis(doc, "Analysis")
    solver = ObjectsFem.makeSolverCalculixCcxTools(doc, "Solver")
    material = ObjectsFem.makeMaterialSolid(doc, "Material")
    material.Material = ALUMINIUM
    thickness = ObjectsFem.makeElementGeometry2D(doc, THICKNESS, "Thickness")
    # The nodes and faces come from the groups of the mesh that bear the constraints' names; FEM asks for a reference all the same.
    stand_in = doc.addObject("Part::Plane", "StandIn")
    doc.recompute()
    root = ObjectsFem.makeConstraintFixed(doc, "Root")
    root.References = [(stand_in, "Face1")]
    pressure = ObjectsFem.makeConstraintPressure(doc, "Pressure")
    pressure.References = [(stand_in, "Face1")]
    pressure.Pressure = PRESSURE
    mesh = doc.addObject("Fem::FemMeshObject", "ShellMesh")
    mesh.FemMesh = with_groups(quads)
    for obj in (solver, material, thickness, root, pressure, mesh):
        analysis.addObject(obj)
    doc.recompute()
    FreeCAD.Console.PrintLog("analysis made\n")
    return analysis, solver


def with_groups(quads):
    """The quad mesh's FemMesh with the groups Root_Nodes and Pressure_Faces."""
    import numpy as np

    from anisoquad.objects.quad_mesh_object import result_of

    fem_mesh = quads.FemMesh.copy()
    root = [node for node, point in fem_mesh.Nodes.items() if abs(point.y) < 1e-3]
    mesh = result_of(quads)
    corners = mesh.points[mesh.quads]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    upper = normal[:, 2] > 0.3 * np.linalg.norm(normal, axis=1)
    for name, kind, ids in (("Root_Nodes", "Node", root), ("Pressure_Faces", "Face", (np.flatnonzero(upper) + 1).tolist())):
        fem_mesh.addGroupElements(fem_mesh.addGroup(name, kind), ids)
    return fem_mesh


def solve(analysis, solver, folder):
    """Run CalculiX; returns the largest displacement at the tip, in millimetres."""
    from femtools.ccxtools import FemToolsCcx

    folder.mkdir(parents=True, exist_ok=True)
    tools = FemToolsCcx(analysis, solver)
    tools.setup_working_dir(str(folder))
    problems = tools.update_objects() or tools.check_prerequisites()
    if problems:
        raise RuntimeError(problems)
    tools.purge_results()
    tools.write_inp_file()
    tools.setup_ccx()
    if tools.ccx_run() != 0:
        raise RuntimeError(f"CalculiX failed: {tools.ccx_stdout[-500:]}")
    tools.load_results()
    result = next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::FemResultObject"))
    nodes = result.Mesh.FemMesh.Nodes
    tip = max(point.y for point in nodes.values())
    lengths = dict(zip(result.NodeNumbers, result.DisplacementLengths))
    return max(lengths[node] for node, point in nodes.items() if point.y > tip - 1e-3 and node in lengths)


def run():
    """Solve both; returns [(name, quads, tip displacement), …]."""
    import FreeCAD

    rows = []
    for name, anisotropy in MESHES:
        doc = FreeCAD.newDocument("WingShell")
        quads = make_model(doc, anisotropy)
        folder = OUT / name.replace(":", "_")
        displacement = solve(*add_analysis(doc, quads), folder)
        doc.saveAs(str(folder / "wing_shell.FCStd"))
        rows.append((name, quads.Quads, displacement))
        FreeCAD.closeDocument(doc.Name)
    return rows


def table(rows):
    """The rows as text, each compared with the first."""
    lines = ["mesh   quads   of 1:1   tip displacement   from 1:1"]
    _, first_quads, first = rows[0]
    for name, quads, displacement in rows:
        lines.append(f"{name:<5}{quads:>7}{100.0 * quads / first_quads:>7.1f} %{displacement:>15.4f} mm{100.0 * (displacement / first - 1.0):>+9.2f} %")
    return "\n".join(lines)


if __name__ == "__main__" or sys.argv[-1].endswith("wing_shell.py"):
    sys.path.append(str(ROOT / "Mod"))
    try:
        print(table(run()))
    except Exception:
        traceback.print_exc()
        sys.exit(1)
    sys.exit(0)
