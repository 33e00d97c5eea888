#pragma once

#include "anisotropy/geodesic_trace.h"

namespace anisoquad {

/// A node at the end of a trace: a triangle node that no front, line or row holds is moved there if one is close by, else an edge
/// close by, or the triangle, is split.
/// @param end not blocked @param reach distance within which a node is close by
Vertex put_node(SurfaceMesh& mesh, const TraceEnd& end, double reach);

}  // namespace anisoquad
