#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Triangles in a bounding-volume hierarchy in one flat array, with their neighbours: closest points, of all facets or
/// of those of one patch, which stand together in it. Of equally close facets the lowest index wins. Queries are const and may
/// run in parallel.
class FacetTree {
  public:
    static constexpr std::int32_t kAnyPatch = -1;

    struct Hit {
        double distance2;
        std::int32_t facet;  ///< -1: none
        Point position;
        Eigen::Vector3d weights;  ///< barycentric
    };

    FacetTree() = default;
    /// @param patch of each facet; empty: all are patch 0
    /// @throws Error{cancelled}
    FacetTree(std::vector<Point> points, std::span<const std::array<std::int32_t, 3>> facets,
              std::span<const std::int32_t> patch = {}, const Context& context = no_context());

    /// @param hint a facet near p, -1: none. A walk from it over neighbours that ends near p, for the facets' size, is the
    ///        answer: a closest point of the sheet that the hint lies on. Else all facets are searched.
    Hit closest(const Point& p, std::int32_t patch, std::int32_t hint) const;
    /// The exact closest point, or, if the walk from the hint finds one within the squared distance `enough2`, any such point.
    Hit closest_or_within(const Point& p, std::int32_t patch, std::int32_t hint, double enough2) const;
    /// The closest point of the facets that face `up`, whose normal has a positive part along it, among those nearer than
    /// `reach`; no facet where there is none.
    Hit closest_facing(const Point& p, std::int32_t patch, const Eigen::Vector3d& up, double reach) const;

    std::int32_t count() const { return static_cast<std::int32_t>(facets_.size()); }
    std::size_t point_count() const { return points_.size(); }
    const Point& point(std::int32_t v) const { return points_[static_cast<std::size_t>(v)]; }
    const std::array<std::int32_t, 3>& facet(std::int32_t f) const { return facets_[static_cast<std::size_t>(f)].corner; }
    std::int32_t patch(std::int32_t f) const { return facets_[static_cast<std::size_t>(f)].patch; }
    /// Facet across the edge from corner k to k + 1, -1: none.
    std::int32_t neighbour(std::int32_t f, int k) const {
        return facets_[static_cast<std::size_t>(f)].neighbour[static_cast<std::size_t>(k)];
    }
    /// Least height of the facet, 0 where it is a point.
    double height(std::int32_t f) const;
    /// Diagonal of the bounding box.
    double diagonal() const { return diagonal_; }

  private:
    /// All that a walk asks of a facet, together in memory.
    struct Facet {
        std::array<std::int32_t, 3> corner;
        std::array<std::int32_t, 3> neighbour{-1, -1, -1};
        std::int32_t patch = 0;
        float near2 = 0.0F;  ///< squared distance at which a walk that ends here needs no search
    };
    struct Node {
        Eigen::Vector3f low;  ///< rounded outwards
        Eigen::Vector3f high;
        std::int32_t first = 0;  ///< leaf: first of its entries in order_; inner node: its right child (the left one follows it)
        std::int32_t count = 0;  ///< leaf: number of facets, 0 = inner node
    };

    void find_neighbours();
    void measure_facets();
    void order_facets();
    std::int32_t cut(std::int32_t first, std::int32_t last) const;
    void build_tree(const Context& context);
    void try_facet(const Point& p, std::int32_t facet, std::int32_t patch, Hit& best) const;
    void try_round(const Point& p, std::int32_t corner, std::int32_t first, std::int32_t patch, Hit& best) const;
    bool walk(const Point& p, std::int32_t patch, std::int32_t hint, Hit& best) const;
    /// @param is_meant says of a facet whether it counts
    template <class IsMeant>
    void search(const Point& p, std::int32_t patch, IsMeant is_meant, Hit& best) const;

    std::vector<Point> points_;
    std::vector<Facet> facets_;
    std::vector<Node> nodes_;
    std::vector<std::int32_t> order_;       ///< facets in the order of the leaves
    std::vector<std::int32_t> patch_root_;  ///< per patch: the node with all its facets, -1 = none
    double diagonal_ = 0.0;
};

}  // namespace anisoquad
