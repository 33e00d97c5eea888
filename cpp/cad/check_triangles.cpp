#include "cad/check_triangles.h"

#include "input/check.h"
#include "input/repair.h"

namespace anisoquad::cad {

void check_triangles(std::span<const Eigen::Vector3d> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    check_input(points, triangles);
}

void mend_triangles(std::vector<Eigen::Vector3d>& points, std::vector<std::array<std::int32_t, 3>>& triangles) {
    RepairResult repaired = repair_surface(points, triangles);
    points = std::move(repaired.points);
    triangles = std::move(repaired.triangles);
}

}  // namespace anisoquad::cad
