"""Surfaces that are hard to mesh, made by VTK: what scans, their decimations and legacy meshes look like.

usage: /usr/bin/python3 tests/benchmark/hard_surfaces.py FOLDER [OFF ...]
       ANISOQUAD_SURFACES=FOLDER PYTHONPATH=Mod /usr/bin/python3 tests/benchmark/surfaces.py
Writes OFF files: isosurfaces by marching cubes, smooth and with noise, and decimated; terrains of scattered points; parametric
surfaces, some of which touch themselves; extruded text, whose caps are coarse; and of every OFF file that is given decimations by two
methods. Needs Debian's python3-vtk9. The same files every time.
"""

import argparse
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

CELLS = (14, 24, 40)  # nodes of the grid for marching cubes along an axis
NOISE = (0.0, 0.15)  # of the sampled values, over the grid's spacing
DECIMATED = (0.5, 0.8, 0.9, 0.96, 0.985)  # share of the triangles that goes: quadrics
DECIMATED_BY_VERTICES = (0.7, 0.9, 0.95)  # and vertex by vertex, which leaves slivers
MERGED = 1e-9  # distance of points that are one, over the diagonal
PARAMETRIC = ("BohemianDome", "Bour", "ConicSpiral", "Dini", "Enneper", "Henneberg", "Kuen", "Mobius", "PluckerConoid", "Pseudosphere",
              "RandomHills", "SuperEllipsoid", "SuperToroid", "Torus")
TEXTS = ("AnisoQuad", "&%@g8", "Sphinx", "FEM 27")


def spheres(x, y, z):
    return np.minimum((x - 0.45) ** 2 + y**2 + z**2 - 0.5, (x + 0.45) ** 2 + y**2 + z**2 - 0.4)


def drilled_box(x, y, z):
    u, v = 0.8 * x + 0.6 * y, -0.6 * x + 0.8 * y
    box = np.maximum(np.maximum(abs(u) - 0.8, abs(v) - 0.5), abs(z) - 0.6)
    return np.maximum(np.maximum(box, 0.3 - np.hypot(x, z)), 0.25 - np.hypot(x, y))


def gyroid(x, y, z):
    x4, y4, z4 = 4 * x, 4 * y, 4 * z
    sheet = np.sin(x4) * np.cos(y4) + np.sin(y4) * np.cos(z4) + np.sin(z4) * np.cos(x4)
    return np.maximum(sheet, x * x + y * y + z * z - 1.4)


def rings(x, y, z):
    product = ((x * x + y * y - 1) ** 2 + z * z) * ((y * y + z * z - 1) ** 2 + x * x) * ((z * z + x * x - 1) ** 2 + y * y)
    return product - 0.075 * (1 + 3 * (x * x + y * y + z * z))


def blobs(x, y, z):
    random = np.random.default_rng(7)
    return 1.6 - sum(random.uniform(0.2, 0.45) ** 2 / ((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 + 1e-3)
                     for a, b, c in random.uniform(-0.7, 0.7, (9, 3)))


SOLIDS = {"blobs": (blobs, 1.3), "drilled_box": (drilled_box, 1.3), "gyroid": (gyroid, 1.3), "rings": (rings, 1.5),
          "spheres": (spheres, 1.3)}  # function that is negative inside, half the edge of the box that is sampled


def output_of(algorithm, *data):
    if data:
        algorithm.SetInputData(*data)
    algorithm.Update()
    return algorithm.GetOutput()


def points_of(array):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(array, float), deep=1))
    return points


def read_off(file):
    numbers = file.read_text().split()[1:]
    vertices, triangles = int(numbers[0]), int(numbers[1])
    values = np.array(numbers[3:3 + 3 * vertices + 4 * triangles], float)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points_of(values[:3 * vertices].reshape(-1, 3)))
    cells = vtk.vtkCellArray()
    for triangle in values[3 * vertices:].reshape(-1, 4)[:, 1:].astype(int).tolist():
        cells.InsertNextCell(3, triangle)
    surface.SetPolys(cells)
    return surface


def write_off(file, surface):
    """Triangles alone, with points that are one merged and without those that none uses."""
    triangles = vtk.vtkTriangleFilter()
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    clean = vtk.vtkCleanPolyData()
    clean.SetTolerance(MERGED)
    clean.ConvertPolysToLinesOff()
    surface = output_of(clean, output_of(triangles, surface))
    faces = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    used, faces = np.unique(faces, return_inverse=True)
    points = vtk_to_numpy(surface.GetPoints().GetData())[used].astype(float)
    with file.open("w") as off:
        off.write(f"OFF\n{len(points)} {faces.size // 3} 0\n")
        np.savetxt(off, points, "%.12g")
        np.savetxt(off, np.insert(faces.reshape(-1, 3), 0, 3, axis=1), "%d")


def decimated(surface, share):
    algorithm = vtk.vtkQuadricDecimation()
    algorithm.SetTargetReduction(share)
    algorithm.VolumePreservationOn()
    return output_of(algorithm, surface)


def decimated_by_vertices(surface, share):
    algorithm = vtk.vtkDecimatePro()
    algorithm.SetTargetReduction(share)
    algorithm.PreserveTopologyOn()
    return output_of(algorithm, surface)


def isosurface(solid, half, cells, noise):
    axis, spacing = np.linspace(-half, half, cells, retstep=True)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    values = solid(x, y, z) + noise * spacing * np.random.default_rng(cells).standard_normal(x.shape)
    image = vtk.vtkImageData()
    image.SetDimensions(cells, cells, cells)
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin(-half, -half, -half)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=1))
    contour = vtk.vtkFlyingEdges3D()
    contour.SetValue(0, 0.0)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    largest = vtk.vtkPolyDataConnectivityFilter()
    largest.SetExtractionModeToLargestRegion()
    return output_of(largest, output_of(contour, image))


def terrain(nodes, height):
    random = np.random.default_rng(nodes)
    x, y = np.vstack([random.uniform(0, 1, (nodes, 2)), [[0, 0], [1, 0], [1, 1], [0, 1]]]).T
    flat = vtk.vtkPolyData()
    flat.SetPoints(points_of(np.column_stack([x, y, 0 * x])))
    surface = output_of(vtk.vtkDelaunay2D(), flat)
    heights = height * (np.sin(9 * x) * np.cos(7 * y) + 0.3 * np.sin(23 * x + 4 * y))
    surface.SetPoints(points_of(np.column_stack([x, y, heights])))
    return surface


def parametric(name):
    function = getattr(vtk, f"vtkParametric{name}")()
    if name.startswith("Super"):
        function.SetN1(0.35)
        function.SetN2(0.45)
    source = vtk.vtkParametricFunctionSource()
    source.SetParametricFunction(function)
    source.SetUResolution(37)
    source.SetVResolution(41)
    source.SetScalarModeToNone()
    return output_of(source)


def extruded(text):
    letters = vtk.vtkVectorText()
    letters.SetText(text)
    extrusion = vtk.vtkLinearExtrusionFilter()
    extrusion.SetExtrusionTypeToVectorExtrusion()
    extrusion.SetVector(0, 0, 0.3)
    return output_of(extrusion, output_of(letters))


def surfaces(given):
    """(name, vtkPolyData) one after the other."""
    for file in given:
        surface = read_off(file)
        for share in DECIMATED:
            yield f"{file.stem}_q{1000 * share:.0f}", decimated(surface, share)
        for share in DECIMATED_BY_VERTICES:
            yield f"{file.stem}_v{1000 * share:.0f}", decimated_by_vertices(surface, share)
    for name, (solid, half) in SOLIDS.items():
        for noise in NOISE:
            for cells in CELLS:
                surface = isosurface(solid, half, cells, noise)
                yield f"{name}_{cells}_noise{100 * noise:.0f}", surface
            for share in (0.9, 0.97):
                yield f"{name}_{cells}_noise{100 * noise:.0f}_q{1000 * share:.0f}", decimated(surface, share)
    for nodes, height in ((300, 0.05), (600, 0.2), (2000, 0.1), (5000, 0.3)):
        yield f"terrain_{nodes}", terrain(nodes, height)
    for name in PARAMETRIC:
        yield f"parametric_{name}", parametric(name)
    for i, text in enumerate(TEXTS):
        yield f"text_{i}", extruded(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("given", type=Path, nargs="*", metavar="OFF")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    count = 0
    for name, surface in surfaces(arguments.given):
        write_off(arguments.folder / f"{name}.off", surface)
        count += 1
    print(f"{count} surfaces in {arguments.folder}")


if __name__ == "__main__":
    main()
