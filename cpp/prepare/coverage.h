#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Keeps the input covered while its triangles are remeshed: points of the input, each held by the triangle of the mesh that is
/// closest to it, must not get farther from the mesh than a bound. Distances of the mesh from the input alone do not notice when
/// a thin edge or a tip draws back. After @cite hu2017error.
class Coverage {
  public:
    using Triangle = std::array<Point, 3>;

    /// @param mesh still the input's own triangles; @param spacing of the points on its curved edges; @param bound in mesh units
    Coverage(const SurfaceMesh& mesh, double spacing, double bound);

    /// Takes the points out of the triangles round a node, or beside an edge.
    void lift(const SurfaceMesh& mesh, Vertex v);
    void lift(const SurfaceMesh& mesh, Edge e);
    /// True if all points taken out are within the bound of one of the triangles, or no farther than they were.
    bool is_covered_by(std::span<const Triangle> triangles) const;
    /// The same for the triangles round a node, where they are now.
    bool is_covered_round(const SurfaceMesh& mesh, Vertex v);
    /// Gives the points taken out to the closest of the triangles round a node, or beside an edge.
    void drop(const SurfaceMesh& mesh, Vertex v);
    void drop(const SurfaceMesh& mesh, Edge e);

  private:
    void add(const Point& p, Face f);
    void lift(const SurfaceMesh& mesh, Face f);
    void drop(const SurfaceMesh& mesh);

    double bound2_;
    std::vector<Point> points_;
    std::vector<std::int32_t> next_;   ///< per point: the next one of its triangle, -1 = last
    std::vector<std::int32_t> first_;  ///< per face slot
    std::vector<std::int32_t> lifted_;
    std::vector<double> lifted_distance2_;  ///< of those, from the triangle they were taken from
    std::vector<Face> faces_;
    std::vector<Triangle> triangles_;
};

}  // namespace anisoquad
