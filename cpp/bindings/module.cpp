#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <memory>
#include <span>
#include <string>

#include "arrays.h"
#include "bindings.h"
#include "quad_mesh.h"

namespace py = pybind11;

namespace anisoquad {
namespace {

using Points = py::array_t<double, py::array::c_style>;
using Triangles = py::array_t<std::int32_t, py::array::c_style>;

/// Calls the user's progress function, and lets Ctrl-C end a run even where there is none.
Context context_for(const py::object& progress) {
    return Context([&progress](std::string_view stage, double fraction) {
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (progress.is_none()) return true;
        const py::object answer = progress(std::string(stage), fraction);
        return !answer.is(py::bool_(false));
    });
}

py::list to_list(std::vector<StageSnapshot>&& stages) {
    py::list list;
    for (StageSnapshot& stage : stages) {
        list.append(py::make_tuple(stage.name, to_array(std::move(stage.points)), to_array(std::move(stage.faces)),
                                   to_array(std::move(stage.row))));
    }
    return list;
}

py::dict to_dict(QuadMeshResult&& result) {
    py::dict dict;
    dict["points"] = to_array(std::move(result.points));
    dict["quads"] = to_array(std::move(result.quads));
    dict["row"] = to_array(std::move(result.row));
    dict["pass_"] = to_array(std::move(result.pass));
    dict["source"] = to_array(std::move(result.source));
    dict["patch"] = to_array(std::move(result.patch));
    dict["node_line"] = to_array(std::move(result.node_line));
    dict["node_input"] = to_array(std::move(result.node_input));
    dict["line_edges"] = to_array(std::move(result.line_edges));
    dict["quad_facet"] = to_array(std::move(result.quad_facet));
    dict["line_edge_input"] = to_array(std::move(result.line_edge_input));
    dict["report"] = to_dict(result.report);
    dict["stages"] = to_list(std::move(result.stages));
    return dict;
}

// The options by value: while the GIL is released, Python may change its own.
py::dict mesh(const Points& points, const Triangles& triangles, const std::vector<Source>& sources, Options options,
              const py::object& progress, const TargetSurface* target) {
    const auto points_of = point_span(points);
    const auto triangles_of = triangle_span(triangles);
    Context context = context_for(progress);
    QuadMeshResult result;
    {
        const py::gil_scoped_release without_gil;
        result = quad_mesh(points_of, triangles_of, sources, options, context, target);
    }
    return to_dict(std::move(result));
}

}  // namespace
}  // namespace anisoquad

PYBIND11_MODULE(_core, module) {
    using namespace anisoquad;
    module.doc() = "The compiled core. Use it through the anisoquad package.";
    module.attr("__version__") = ANISOQUAD_VERSION;
    bind_errors();
    bind_options(module);
    bind_fem_mesh(module);
    bind_picking(module);
    py::class_<TargetSurface, std::shared_ptr<TargetSurface>>(
        module, "TargetSurface", "The surface behind the triangles, onto which nodes are brought; see anisoquad.cad.");
    module.def("quad_mesh", &mesh, py::arg("points").noconvert(), py::arg("triangles").noconvert(), py::arg("sources"),
               py::arg("options"), py::arg("progress"), py::arg("target") = nullptr,
               "See anisoquad.quad_mesh. Returns the fields of QuadMesh as a dict.");
}
