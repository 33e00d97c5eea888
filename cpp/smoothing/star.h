#pragma once

#include <array>
#include <cstdint>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// The faces round one node, copied into flat arrays: what a smoother evaluates for many trial places of the node without
/// walking over the mesh.
class Star {
  public:
    static constexpr int kCapacity = 32;

    /// @returns false if the node has no face or more than kCapacity of them
    bool gather(const SurfaceMesh& mesh, Vertex v);

    int size() const { return size_; }
    /// The node's place when the star was gathered.
    const Point& centre() const { return centre_; }
    /// Unit sum of the faces' area vectors, see node_normal().
    const Eigen::Vector3d& normal() const { return normal_; }
    void set_normal(const Eigen::Vector3d& normal) { normal_ = normal; }
    /// Mean length of the node's edges.
    double edge_length() const { return edge_length_; }
    std::int32_t patch() const { return patch_; }

    struct Quality {
        double worst = 1.0;
        double mean = 1.0;
    };
    /// Quality of the faces with the node at p, seen along normal() (measures: see worst_quality()).
    Quality quality(const Point& p) const;
    /// Smallest corner area of the faces, signed along normal(), over the squared mean edge length: what tells a less inverted
    /// star from a more inverted one.
    double smallest_corner_area(const Point& p) const;

  private:
    struct Wedge {
        Point next;      ///< node after the centre
        Point opposite;  ///< quads only
        Point previous;
        bool quad;
    };
    double quality(const Wedge& wedge, const Point& p) const;

    std::array<Wedge, kCapacity> wedges_;
    int size_ = 0;
    Point centre_ = Point::Zero();
    Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
    double edge_length_ = 0.0;
    std::int32_t patch_ = -1;
};

}  // namespace anisoquad
