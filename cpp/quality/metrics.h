#pragma once

#include "mesh/surface_mesh.h"

/// Shape measures of one quad with the nodes a, b, c, d in order, as defined by VTK's verdict (Stimpson et al., *The Verdict
/// Geometric Quality Library*, Sandia report 2007-1751). All but area() are free of units. The overloads for a face take
/// the nodes from halfedge(f) on. @pre the face is a quad
namespace anisoquad {

/// Scaled Jacobian up to which an element counts as inverted: beyond it rounding no longer chooses the sign. A corner of 180° has
/// 0.
constexpr double kLeastUpright = 1e-6;

/// Smallest sine of a corner, negative where a corner is folded; the quad's own normal (cross product of its two principal
/// axes) says which side is up, so a quad that is turned over as a whole counts as good. −1…1, 0 when an edge has no length.
double scaled_jacobian(const Point& a, const Point& b, const Point& c, const Point& d);
double scaled_jacobian(const SurfaceMesh& mesh, Face f);
/// Of the quad that the two triangles at the edge of h make.
double scaled_jacobian_of_pair(const SurfaceMesh& mesh, HalfEdge h);
/// The same with respect to a given surface normal (any length but zero): a quad that is turned over is negative.
double scaled_jacobian(const Point& a, const Point& b, const Point& c, const Point& d, const Eigen::Vector3d& normal);
double scaled_jacobian(const SurfaceMesh& mesh, Face f, const Eigen::Vector3d& normal);

/// Longest over shortest edge, 1…∞; infinite when an edge has no length.
double aspect_ratio(const Point& a, const Point& b, const Point& c, const Point& d);
double aspect_ratio(const SurfaceMesh& mesh, Face f);

/// Smallest angle between two neighbouring edges, degrees, 0…90; 0 when an edge has no length.
double min_angle(const Point& a, const Point& b, const Point& c, const Point& d);
double min_angle(const SurfaceMesh& mesh, Face f);

/// Largest angle between two neighbouring edges, degrees, up to 360 (above 180 where a corner is folded); 360 when an edge has
/// no length.
double max_angle(const Point& a, const Point& b, const Point& c, const Point& d);
double max_angle(const SurfaceMesh& mesh, Face f);

/// Cosine of the angle between the two principal axes, 0 (rectangle) … 1.
double skew(const Point& a, const Point& b, const Point& c, const Point& d);
double skew(const SurfaceMesh& mesh, Face f);

/// Largest angle between the normals of the two triangles that either diagonal makes of the quad, degrees, 0 (flat) … 180.
/// Verdict gives the cube of its cosine.
double warpage(const Point& a, const Point& b, const Point& c, const Point& d);
double warpage(const SurfaceMesh& mesh, Face f);

/// Area in the plane of the quad's own normal, user's unit squared, ≥ 0.
double area(const Point& a, const Point& b, const Point& c, const Point& d);
double area(const SurfaceMesh& mesh, Face f);

}  // namespace anisoquad
