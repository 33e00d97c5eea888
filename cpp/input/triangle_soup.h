#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// What the steps of the repair work on: facets that may share anything, and where each vertex comes from. Vertices keep the
/// input's indices; new ones follow. Vertices that are merged or unused stay, without facets.
struct TriangleSoup {
    /// The edge a – b has become a – middle – b.
    struct HalvedEdge {
        std::int32_t a;
        std::int32_t b;
        std::int32_t middle;
    };

    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> origin;       ///< per vertex: input vertex at its place, -1 = none
    std::vector<std::int32_t> merged_into;  ///< per vertex: the lower one that stands for it, itself if none does
    std::vector<HalvedEdge> halved;

    const Point& point(std::int32_t v) const { return points[static_cast<std::size_t>(v)]; }
    std::int32_t facet_count() const { return static_cast<std::int32_t>(triangles.size()); }
    /// @param corner 3·facet + corner of the facet
    std::int32_t vertex(std::int32_t corner) const {
        return triangles[static_cast<std::size_t>(corner / 3)][static_cast<std::size_t>(corner % 3)];
    }

    std::int32_t add_vertex(const Point& p, std::int32_t input) {
        points.push_back(p);
        origin.push_back(input);
        merged_into.push_back(static_cast<std::int32_t>(points.size()) - 1);
        return merged_into.back();
    }

    /// The vertex that stands for v after all merges.
    std::int32_t root(std::int32_t v) const {
        while (merged_into[static_cast<std::size_t>(v)] != v) v = merged_into[static_cast<std::size_t>(v)];
        return v;
    }

    /// Lets the lower of two vertices stand for both; the facets follow with apply_merges().
    void merge(std::int32_t a, std::int32_t b) {
        a = root(a);
        b = root(b);
        merged_into[static_cast<std::size_t>(a > b ? a : b)] = a > b ? b : a;
    }

    void apply_merges() {
        for (std::size_t v = 0; v < merged_into.size(); ++v)
            merged_into[v] = merged_into[static_cast<std::size_t>(merged_into[v])];
        for (auto& t : triangles) {
            for (auto& v : t) v = root(v);
        }
    }
};

}  // namespace anisoquad
