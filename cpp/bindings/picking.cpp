#include <pybind11/stl.h>

#include <memory>
#include <span>

#include "arrays.h"
#include "bindings.h"
#include "input/check.h"
#include "picking/best_path.h"
#include "picking/edge_on_ray.h"
#include "picking/imprint.h"
#include "picking/onto_surface.h"
#include "picking/ridge.h"
#include "picking/zigzag.h"

namespace py = pybind11;

namespace anisoquad {
namespace {

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Triangles = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;
using Mask = py::array_t<bool, py::array::c_style | py::array::forcecast>;
using Ids = std::vector<std::int32_t>;
using EdgeList = std::vector<std::array<std::int32_t, 2>>;

PickSurface make(const Points& points, const Triangles& triangles, double feature_angle, const EdgeList& feature_edges) {
    const auto points_of = point_span(points);
    const auto triangles_of = triangle_span(triangles);
    const py::gil_scoped_release without_gil;
    return make_pick_surface(points_of, triangles_of, feature_angle, feature_edges);
}

py::object edge_hit(const PickSurface& surface, const Point& origin, const Point& direction, double reach) {
    const EdgeHit hit = edge_on_ray(surface, origin, direction, reach);
    if (hit.from < 0) return py::none();
    return py::make_tuple(hit.facet, py::make_tuple(hit.point.x(), hit.point.y(), hit.point.z()),
                          py::make_tuple(hit.from, hit.to));
}

py::tuple imprinted(const PickSurface& surface, const Ids& path) {
    ImprintResult result;
    {
        const py::gil_scoped_release without_gil;
        result = imprint(surface, path);
    }
    return py::make_tuple(to_array(std::move(result.points)), to_array(std::move(result.triangles)), result.path, result.pieces);
}

py::array projected(const PickSurface& surface, const Points& points, const Mask& on_line) {
    if (on_line.ndim() != 1 || on_line.shape(0) != points.shape(0)) throw std::invalid_argument("on_line must have shape (N,)");
    const std::span<const Point> points_of = point_span(points);
    const std::span<const bool> mask(on_line.data(), static_cast<std::size_t>(on_line.shape(0)));
    std::vector<Point> result;
    {
        const py::gil_scoped_release without_gil;
        result = onto_surface(surface, points_of, mask);
    }
    return to_array(std::move(result));
}

}  // namespace

void bind_picking(py::module_& module) {
    using Coordinates = std::array<double, 3>;
    py::class_<PickSurface>(module, "PickSurface", "The triangulation on which lines are picked. See anisoquad.surface_lines.")
        .def(py::init(&make), py::arg("points"), py::arg("triangles"), py::arg("feature_angle"),
             py::arg("feature_edges") = EdgeList{})
        .def(
            "edge_on_ray",
            [](const PickSurface& surface, const Coordinates& origin, const Coordinates& direction, double reach) {
                return edge_hit(surface, Point(origin.data()), Point(direction.data()), reach);
            },
            py::arg("origin"), py::arg("direction"), py::arg("reach") = 0.0, "(facet, point, (from, to)), or None")
        .def("best_path", &best_path, py::arg("start"), py::arg("end"), "Vertex ids along ridges and feature lines")
        .def("whole_line", &whole_line, py::arg("start"), py::arg("end"), "Vertex ids of the line through a mesh edge")
        .def("suggest_lines", &suggest_lines, "Vertex ids of lines that look like leading and trailing edges")
        .def(
            "is_zigzag",
            [](const PickSurface& surface, const Ids& path) {
                const Source source{path, {}, Sides::both};
                check_sources(surface.mesh, std::span(&source, 1));
                std::vector<Vertex> vertices;
                for (const std::int32_t v : path) vertices.emplace_back(v);
                return is_zigzag(surface.mesh, vertices);
            },
            py::arg("path"))
        .def("imprint", &imprinted, py::arg("path"), "(points, triangles, path, number of straightened pieces)")
        .def("onto_surface", &projected, py::arg("points"), py::arg("on_line"),
             "(N,3) points on the surface, or on its feature lines");
}

}  // namespace anisoquad
