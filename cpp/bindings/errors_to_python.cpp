#include "errors.h"

#include <exception>

#include "bindings.h"

namespace py = pybind11;

namespace anisoquad {
namespace {

void raise_in_python(const Error& error) {
    const py::module_ errors = py::module_::import("anisoquad.errors");
    const py::object type = errors.attr(error.code() == ErrorCode::cancelled ? "Cancelled" : "MeshError");
    py::list ids;
    for (const std::int32_t id : error.ids()) ids.append(id);
    const py::object value = type(error.what(), py::arg("code") = py::str(std::string(name(error.code()))),
                                  py::arg("kind") = py::str(std::string(name(error.kind()))), py::arg("ids") = ids);
    PyErr_SetObject(type.ptr(), value.ptr());
}

}  // namespace

void bind_errors() {
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Error& error) {
            try {
                raise_in_python(error);
            } catch (py::error_already_set& failed) {
                failed.restore();
            }
        }
    });
}

}  // namespace anisoquad
