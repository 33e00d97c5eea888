#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Where a mesh was cut into parts: planes across an axis, each within the box of what it cuts.
class Cuts {
  public:
    void add(int axis, double place, const Eigen::AlignedBox3d& box) { cuts_.push_back({axis, place, box}); }
    bool empty() const { return cuts_.empty(); }
    /// True if a cut is no further than `distance` from the point.
    bool is_near(const Point& p, double distance) const;

  private:
    struct Cut {
        int axis;
        double place;
        Eigen::AlignedBox3d box;
    };
    std::vector<Cut> cuts_;
};

}  // namespace anisoquad
