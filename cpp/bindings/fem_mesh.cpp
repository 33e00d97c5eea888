#include <pybind11/numpy.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

#include "bindings.h"

namespace py = pybind11;

namespace anisoquad {
namespace {

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Quads = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

/// Calls a bound method with N arguments that were made for this call.
template <std::size_t N>
void call(const py::object& method, const std::array<PyObject*, N>& made) {
    std::array<PyObject*, N> arguments = made;
    bool complete = true;
    for (PyObject* argument : arguments) complete = complete && argument != nullptr;
    PyObject* result = complete ? PyObject_Vectorcall(method.ptr(), arguments.data(), N, nullptr) : nullptr;
    for (PyObject* argument : arguments) Py_XDECREF(argument);
    if (result == nullptr) throw py::error_already_set();
    Py_DECREF(result);
}

/// Lets other threads run between one call in 4096 and the next: FreeCAD's window lives on while a thread of ours fills a mesh.
/// A release alone would not do: this thread has the lock back before another wakes, and each release restarts the time after
/// which the other may demand it.
void yield_after(py::ssize_t calls) {
    if (calls % 4096 != 0) return;
    const py::gil_scoped_release without_gil;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
}

PyObject* list_of(const std::int32_t* nodes, py::ssize_t count) {
    PyObject* list = PyList_New(count);
    for (py::ssize_t i = 0; list != nullptr && i < count; ++i) PyList_SET_ITEM(list, i, PyLong_FromLong(nodes[i] + 1L));
    return list;
}

/// FreeCAD 0.20 has no bulk call; through bound methods it takes a sixth of the time of a Python loop, and no FreeCAD headers.
void fill_fem_mesh(const py::object& fem_mesh, const Points& points, const Quads& quads) {
    if (points.ndim() != 2 || points.shape(1) != 3) throw std::invalid_argument("points must have shape (N, 3)");
    if (quads.ndim() != 2 || (quads.shape(1) != 4 && quads.shape(1) != 8)) {
        throw std::invalid_argument("quads must have shape (Q, 4) or (Q, 8)");
    }
    const py::object add_node = fem_mesh.attr("addNode");
    const py::object add_quad = fem_mesh.attr("addQuad");
    const py::object add_face = fem_mesh.attr("addFace");
    const auto xyz = points.unchecked<2>();
    for (py::ssize_t i = 0; i < points.shape(0); ++i) {
        call<4>(add_node, {PyFloat_FromDouble(xyz(i, 0)), PyFloat_FromDouble(xyz(i, 1)), PyFloat_FromDouble(xyz(i, 2)),
                           PyLong_FromSsize_t(i + 1)});
        yield_after(i + 1);
    }
    const auto node = quads.unchecked<2>();
    for (py::ssize_t i = 0; i < quads.shape(0); ++i) {
        if (quads.shape(1) == 8) {
            call<2>(add_face, {list_of(quads.data(i, 0), 8), PyLong_FromSsize_t(i + 1)});
        } else {
            call<4>(add_quad, {PyLong_FromLong(node(i, 0) + 1L), PyLong_FromLong(node(i, 1) + 1L),
                               PyLong_FromLong(node(i, 2) + 1L), PyLong_FromLong(node(i, 3) + 1L)});
        }
        yield_after(i + 1);
    }
}

}  // namespace

void bind_fem_mesh(py::module_& module) {
    module.def("fill_fem_mesh", &fill_fem_mesh, py::arg("fem_mesh"), py::arg("points"), py::arg("quads"),
               "Add points (N,3) and quads (Q,4) or (Q,8) to an empty Fem.FemMesh; node and face ids count from 1.");
}

}  // namespace anisoquad
