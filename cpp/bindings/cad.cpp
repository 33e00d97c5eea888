#include <pybind11/stl.h>

#include <memory>
#include <span>
#include <string>

#include "arrays.h"
#include "bindings.h"
#include "cad/cad_surface.h"
#include "cad/edge_chain.h"
#include "cad/link_mesh.h"
#include "cad/read_shape.h"
#include "cad/shape.h"
#include "cad/smooth_edges.h"
#include "cad/triangulate.h"

namespace py = pybind11;

namespace anisoquad::cad {
namespace {

using PointArray = py::array_t<double, py::array::c_style>;
using TriangleArray = py::array_t<std::int32_t, py::array::c_style>;
using Ids = std::vector<std::int32_t>;
using ShapePointer = std::shared_ptr<CadShape>;

ShapePointer make_shape(TopoDS_Shape read, const std::string& name, bool check) {
    auto shape = std::make_shared<CadShape>(std::move(read), name);
    if (check) check_shape(*shape);
    return shape;
}

std::shared_ptr<CadSurface> linked_surface(const ShapePointer& shape, const PointArray& points, const TriangleArray& triangles,
                                           double smooth_angle, const Triangulation* made) {
    const auto points_of = point_span(points);
    const auto triangles_of = triangle_span(triangles);
    const py::gil_scoped_release without_gil;
    const bool same = made && is_same(*made, points_of, triangles_of, shape->diagonal());
    // Rounded to single precision, as the caller may have them, thin facets can lose their area.
    auto linked = std::make_shared<const MeshLink>(same ? link_mesh(*shape, made->points, triangles_of, made->origin)
                                                        : link_mesh(*shape, points_of, triangles_of));
    const std::vector<char> joined = smooth_angle > 0.0 ? smooth_edges(*shape, smooth_angle) : std::vector<char>();
    return std::make_shared<CadSurface>(shape, std::move(linked), triangles_of, joined);
}

py::array projected(const CadSurface& surface, const PointArray& points, const std::vector<std::int32_t>& facets,
                    const std::vector<std::array<std::int32_t, 2>>& edges) {
    const auto points_of = point_span(points);
    const auto count = static_cast<std::int32_t>(surface.link().facet_face.size());
    if (facets.size() != points_of.size() || edges.size() != points_of.size())
        throw std::invalid_argument("one facet and edge for each point");
    std::vector<Eigen::Vector3d> moved(points_of.begin(), points_of.end());
    {
        const py::gil_scoped_release without_gil;
        std::vector<TargetPlace> places;
        for (std::size_t i = 0; i < facets.size(); ++i) {
            if (facets[i] < 0 || facets[i] >= count) throw std::invalid_argument("no such facet");
            places.push_back({facets[i], Eigen::Vector3d::Constant(1.0 / 3.0), edges[i], 0.5});
        }
        surface.project(places, moved);
    }
    return to_array(std::move(moved));
}

py::list entities(const MeshLink& link) {
    constexpr const char* kinds[] = {"face", "edge", "vertex"};
    py::list list;
    for (const Entity& e : link.entity) list.append(py::make_tuple(kinds[static_cast<std::size_t>(e.kind)], e.index));
    return list;
}

}  // namespace
}  // namespace anisoquad::cad

PYBIND11_MODULE(_cad, module) {
    using namespace anisoquad;
    using namespace anisoquad::cad;
    module.doc() = "The compiled part that needs OpenCASCADE. Use it through anisoquad.cad.";
    bind_errors();
    py::module_::import("anisoquad._core");  // knows TargetSurface

    py::class_<CadShape, ShapePointer>(module, "CadShape")
        .def_static(
            "from_brep",
            [](const std::string& text, const std::string& name, bool check) { return make_shape(read_brep(text), name, check); },
            py::arg("text"), py::arg("name"), py::arg("check"), py::call_guard<py::gil_scoped_release>())
        .def_static(
            "from_file",
            [](const std::string& path, const std::string& name, bool check) {
                return make_shape(read_shape(path), name, check);
            },
            py::arg("path"), py::arg("name"), py::arg("check"), py::call_guard<py::gil_scoped_release>())
        .def("invalid_faces", &invalid_faces, py::call_guard<py::gil_scoped_release>())
        .def("check", &check_shape, py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("name", &CadShape::name)
        .def_property_readonly("diagonal", &CadShape::diagonal)
        .def_property_readonly("face_count", [](const CadShape& s) { return s.faces().size(); })
        .def_property_readonly("edge_count", [](const CadShape& s) { return s.edges().size(); })
        .def(
            "triangulate",
            [](const CadShape& shape, double deflection, double angle) {
                const py::gil_scoped_release without_gil;
                return std::make_shared<Triangulation>(triangulate(shape, {deflection, angle}));
            },
            py::arg("deflection"), py::arg("angle"))
        .def(
            "tangent_chain",
            [](const CadShape& shape, std::int32_t edge, double angle) {
                py::list list;
                for (const DirectedEdge& e : tangent_chain(shape, edge, angle)) list.append(py::make_tuple(e.edge, e.reversed));
                return list;
            },
            py::arg("edge"), py::arg("angle"));

    py::class_<Triangulation, std::shared_ptr<Triangulation>>(module, "Triangulation")
        .def_property_readonly("points", [](const Triangulation& t) { return to_array(std::vector(t.points)); })
        .def_property_readonly("triangles", [](const Triangulation& t) { return to_array(std::vector(t.triangles)); });

    py::class_<CadSurface, TargetSurface, std::shared_ptr<CadSurface>>(module, "CadSurface")
        .def(py::init(&linked_surface), py::arg("shape"), py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("smooth_angle"), py::arg("made"))
        .def_property_readonly("points",
                               [](const CadSurface& s) { return to_array(std::vector<Eigen::Vector3d>(s.link().points)); })
        .def_property_readonly("facet_face",
                               [](const CadSurface& s) { return to_array(std::vector<std::int32_t>(s.link().facet_face)); })
        .def_property_readonly("entities", [](const CadSurface& s) { return entities(s.link()); })
        .def(
            "edge_path", [](const CadSurface& s, std::size_t edge) { return s.link().paths.at(edge).vertices; }, py::arg("edge"))
        .def("feature_edges", &CadSurface::feature_edges)
        .def(
            "path",
            [](const CadSurface& s, const Ids& edges, bool reversed) {
                return path_on_edges(s.shape(), s.link().paths, edges, reversed);
            },
            py::arg("edges"), py::arg("reversed"))
        .def("project", &projected, py::arg("points"), py::arg("facets"), py::arg("edges"))
        .def("edge_of", &CadSurface::edge_of, py::arg("a"), py::arg("b"));
}
