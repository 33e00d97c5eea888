#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Closest point of a surface.
struct SurfacePoint {
    Point position = Point::Zero();
    std::int32_t facet = -1;  ///< -1: no facet (empty surface, or no facet of the wanted patch)
    double distance = 0.0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, interpolated from the corners' normals inside the patch
};

/// The input triangulation, kept unchanged: what nodes are brought back to after they were moved.
///
/// Closest points come from a bounding-volume hierarchy in one flat array; of equally close facets the lowest index wins. Queries
/// are const and may run in parallel.
class ReferenceSurface {
  public:
    static constexpr std::int32_t kAnyPatch = -1;

    ReferenceSurface() = default;
    /// @param facet_patch patch of each facet; empty: all are patch 0
    /// @param crease_angle degrees; a corner's normal is the mean over the facets that are reached from its facet round the
    ///        vertex without crossing an edge between patches or one where the facets turn by more than this
    ReferenceSurface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                     std::span<const std::int32_t> facet_patch = {}, double crease_angle = 40.0);

    SurfacePoint closest(const Point& p, std::int32_t patch = kAnyPatch) const;
    /// The same, faster when `hint` is a facet near p (-1: none). A walk from it over neighbours that ends within a twentieth
    /// of the facets' size of p is the answer: the closest point of the sheet that the hint lies on, where a thin body has another one
    /// closer by. Else all facets are searched.
    SurfacePoint closest(const Point& p, std::int32_t patch, std::int32_t hint) const;

    /// Closest point, lifted off its facet by the quadratic that has the corners' normals, so that a curved surface is not
    /// flattened onto its facets (α = 1/2 of @cite boubekeur2008phong is exact for quadrics). The lift is zero on flat facets
    /// and never more than a tenth of the facet's height or 5e-4 of the surface's diagonal.
    /// @param hint in: facet near p or -1, out: facet of the closest point
    Point project(const Point& p, std::int32_t patch, std::int32_t& hint) const;

    std::int32_t facet_count() const { return static_cast<std::int32_t>(facets_.size()); }
    std::int32_t facet_patch(std::int32_t facet) const { return patch_[static_cast<std::size_t>(facet)]; }
    const Eigen::Vector3d& facet_normal(std::int32_t facet) const { return facet_normal_[static_cast<std::size_t>(facet)]; }
    /// Diagonal of the bounding box.
    double diagonal() const { return diagonal_; }

  private:
    struct Node {
        Eigen::Vector3d low;
        Eigen::Vector3d high;
        std::int32_t first = 0;  ///< leaf: first of its entries in order_; inner node: its right child (the left one follows it)
        std::int32_t count = 0;  ///< leaf: number of facets, 0 = inner node
        std::int32_t patch = kAnyPatch;  ///< patch of all facets below, kAnyPatch = several
    };
    struct Candidate {
        double distance2;
        std::int32_t facet;
        Point position;
        Eigen::Vector3d weights;  ///< barycentric
    };

    void find_neighbours();
    void compute_normals(double crease_angle);
    void build_tree();
    void try_facet(const Point& p, std::int32_t facet, std::int32_t patch, Candidate& best) const;
    bool walk(const Point& p, std::int32_t patch, std::int32_t hint, Candidate& best) const;
    void try_round(const Point& p, std::int32_t corner, std::int32_t first, std::int32_t patch, Candidate& best) const;
    double extent2(std::int32_t facet) const;
    Candidate search(const Point& p, std::int32_t patch, std::int32_t hint) const;
    Eigen::Vector3d interpolated_normal(const Candidate& c) const;

    std::vector<Point> points_;
    std::vector<std::array<std::int32_t, 3>> facets_;
    std::vector<std::int32_t> patch_;
    std::vector<std::array<std::int32_t, 3>> neighbour_;  ///< across the edge from corner k to k+1, -1 = none
    std::vector<Eigen::Vector3d> facet_normal_;
    std::vector<std::array<Eigen::Vector3d, 3>> corner_normal_;
    std::vector<Node> nodes_;
    std::vector<std::int32_t> order_;  ///< facets in the order of the leaves
    double diagonal_ = 0.0;
};

}  // namespace anisoquad
