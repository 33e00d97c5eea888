#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// A triangulation of a surface by its lengths alone: its edges are straight on the surface, and need not be edges of the
/// mesh. Half-edges have the indices of the mesh that it was made of, and keep them in flips @cite sharp2020.
class IntrinsicTriangulation {
  public:
    /// @pre all faces are triangles
    explicit IntrinsicTriangulation(const SurfaceMesh& mesh);

    static HalfEdge twin(HalfEdge h) { return SurfaceMesh::twin(h); }
    HalfEdge next(HalfEdge h) const { return next_[at(h)]; }
    HalfEdge prev(HalfEdge h) const { return next(next(h)); }
    Vertex from(HalfEdge h) const { return from_[at(h)]; }
    Vertex to(HalfEdge h) const { return from_[at(twin(h))]; }
    bool has_face(HalfEdge h) const { return next_[at(h)].is_valid(); }
    double length(HalfEdge h) const { return length_[at(h)]; }
    /// Angle at from(h) inside the triangle of h.
    double angle(HalfEdge h) const;
    /// Direction of h at from(h): the angle, counter-clockwise, from a half-edge of the mesh that is the same for all.
    double direction(HalfEdge h) const { return direction_[at(h)]; }
    /// Sum of the angles at a vertex.
    double total_angle(Vertex v) const { return total_angle_[static_cast<std::size_t>(v.index())]; }

    /// Turns the edge into the other diagonal of its two triangles. @pre they form a convex quadrilateral
    void flip(HalfEdge h);

  private:
    static std::size_t at(HalfEdge h) { return static_cast<std::size_t>(h.index()); }

    std::vector<HalfEdge> next_;  ///< invalid where there is no face
    std::vector<Vertex> from_;
    std::vector<double> length_;
    std::vector<double> direction_;
    std::vector<double> total_angle_;
};

}  // namespace anisoquad
