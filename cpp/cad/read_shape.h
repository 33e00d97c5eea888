#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string_view>

namespace anisoquad::cad {

/// The shape of a text in OpenCASCADE's BREP format, as FreeCAD's exportBrepToString() gives it.
/// @throws Error{invalid_shape}
TopoDS_Shape read_brep(std::string_view text);

/// The shape of a STEP (.step, .stp), IGES (.iges, .igs) or BREP (.brep, .brp) file, in millimetres as far as the format
/// knows units. Faces of IGES files, which know no common edges, are sewn together.
/// @throws Error{invalid_shape} that names the file
TopoDS_Shape read_shape(const std::filesystem::path& path);

}  // namespace anisoquad::cad
