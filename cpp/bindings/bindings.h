#pragma once

#include <pybind11/pybind11.h>

#include "quality/report.h"

namespace anisoquad {

/// Makes the core's errors arrive as `anisoquad.MeshError` and `anisoquad.Cancelled`.
void bind_errors();

/// Adds `Options`, `Pass`, `Sides`, `Source` and `passes_for_anisotropy`.
void bind_options(pybind11::module_& module);

/// Adds `fill_fem_mesh`.
void bind_fem_mesh(pybind11::module_& module);

/// Adds `PickSurface`.
void bind_picking(pybind11::module_& module);

/// The report as a dict of numbers, strings, lists and dicts, with the names of the C++ fields.
pybind11::dict to_dict(const Report& report);

}  // namespace anisoquad
