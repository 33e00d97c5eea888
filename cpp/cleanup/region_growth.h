#pragma once

#include <vector>

#include "cleanup/patch_mesh.h"
#include "cleanup/trial.h"

namespace anisoquad {

/// Replaces regions with several irregular nodes by patches with fewer (@cite verma2017regularization): from an irregular node
/// the region grows to the nearest other ones, and is made convex on the way, until a patch with as many corners as the outline
/// has is less irregular.
class RegionGrowth {
  public:
    struct Limits {
        std::size_t faces = 250;
        int steps = 10;  ///< irregular nodes that are added one after the other
        int rings = 6;   ///< rings of quads that are added round the seed, if that fails
        Trial::Demands demands = {};
    };

    explicit RegionGrowth(Trial& trial, PatchPlanner& planner) : trial_(trial), planner_(planner) {}

    /// @param region receives the new quads @returns true if something was replaced
    bool improve(Vertex seed, const Limits& limits, Region& region);

  private:
    bool begin(Vertex seed, Region& region);
    void add_ring(Region& region);
    bool grow_to_next(Region& region, const Limits& limits);
    bool make_convex(Region& region, const Limits& limits);
    bool try_patch(Region& region, const Trial::Demands& demands);
    /// How many quads of the region belong at the outline's i-th node: 1 corner, 2 side, 3 and more: not convex.
    int wanted_inside(const Region& region, std::size_t i) const;
    void add_faces_at(HalfEdge h, Region& region);

    Trial& trial_;
    PatchPlanner& planner_;
    Marks faces_;
    Marks reached_;
    std::vector<Face> front_;
    std::vector<Face> from_;
};

}  // namespace anisoquad
