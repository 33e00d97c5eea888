#include "options.h"

#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;

namespace anisoquad {
namespace {

constexpr const char* options_doc =
    "What a user can set. Every keyword is one of Options.fields; what is not given keeps the default of the C++ core.";

Options options_from_keywords(const py::kwargs& keywords) {
    py::object options = py::cast(Options{});
    const py::dict fields = options.attr("fields");
    for (const auto& [name, value] : keywords) {
        if (!fields.contains(name)) throw py::type_error("Options has no field '" + py::cast<std::string>(name) + "'");
        try {
            options.attr(name) = value;
        } catch (py::error_already_set& error) {
            if (!error.matches(PyExc_TypeError)) throw;
            throw py::type_error("Options." + py::cast<std::string>(name) + " can not be " +
                                 py::cast<std::string>(py::repr(value)));
        }
    }
    return options.cast<Options>();
}

/// Binds the fields and keeps their names and docs in `Options.fields`, from which panels and properties are made.
class OptionFields {
  public:
    explicit OptionFields(py::class_<Options>& type) : type_(type) {}

    template <class Field>
    OptionFields& add(const char* name, Field Options::*field, const char* doc) {
        type_.def_readwrite(name, field, doc);
        fields_[name] = doc;
        return *this;
    }

    void finish() { type_.attr("fields") = fields_; }

  private:
    py::class_<Options>& type_;
    py::dict fields_;
};

}  // namespace

void bind_options(py::module_& module) {
    py::class_<Options> options(module, "Options", options_doc);
    options.def(py::init(&options_from_keywords));
    OptionFields(options)
        .add("feature_angle", &Options::feature_angle, "Degrees; edges whose facets turn by more are feature lines")
        .add("feature_edges", &Options::feature_edges, "Further feature edges, as pairs of input vertex ids")
        .add("repair", &Options::repair, "Mend bad input instead of rejecting it; the report says what was changed")
        .add("prepare", &Options::prepare,
             "Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded")
        .add("size", &Options::size, "Wanted edge length of the quads; remeshes all patches. 0: that of the triangles")
        .add("vertex_size", &Options::vertex_size, "Wanted edge lengths, one per input vertex, instead of size")
        .add("growth", &Options::growth, "Limit between the sizes of neighbouring elements where patches are remeshed")
        .add("curvature_angle", &Options::curvature_angle,
             "Degrees that one edge may turn along the surface where patches are remeshed; 0: any")
        .add("row_growth", &Options::row_growth,
             "Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may "
             "grow by 1.6")
        .add("smoothing_passes", &Options::smoothing_passes, "Limit of sweeps of the final smoothing")
        .add("cleanup", &Options::cleanup, "Topological clean-up after the fill")
        .add("threads", &Options::threads,
             "Most threads that a run uses; 0: as many as there are cores. The mesh is the same for any number")
        .add("validate", &Options::validate, "Check the invariants of the mesh after every stage")
        .add("record_stages", &Options::record_stages, "Keep a copy of the mesh after every rows and merge step")
        .finish();

    py::enum_<Sides>(module, "Sides").value("both", Sides::both).value("left", Sides::left).value("right", Sides::right);

    py::class_<Pass>(module, "Pass", "One pass: quads merged into one along the source, rows (0: as many as fit).")
        .def(py::init([](int ratio, int rows) {
                 return Pass{ratio, rows};
             }),
             py::arg("ratio"), py::arg("rows") = 0)
        .def_readonly("ratio", &Pass::ratio)
        .def_readonly("rows", &Pass::rows);

    py::class_<Source>(module, "Source", "A line source: vertex ids, passes, sides.")
        .def(py::init([](std::vector<std::int32_t> vertices, std::vector<Pass> passes, Sides sides) {
                 return Source{std::move(vertices), std::move(passes), sides};
             }),
             py::arg("vertices"), py::arg("passes"), py::arg("sides"));

    module.def("passes_for_anisotropy", &passes_for_anisotropy, py::arg("anisotropy"),
               "The paper's passes for a maximum anisotropy: one up to 5, then products whose last pass is 2.");
}

}  // namespace anisoquad
