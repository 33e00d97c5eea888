#include "cad/check_triangles.h"

#include <algorithm>
#include <utility>

#include "input/check.h"
#include "input/repair.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::int32_t, 3>;

/// For each triangle of `now` that of `before` with its corners at the same places, whichever way it turns; -1 = none.
std::vector<std::int32_t> same_triangles(std::span<const Vector3d> points_before, std::span<const Triangle> before,
                                         std::span<const Vector3d> points_now, std::span<const Triangle> now) {
    using Place = std::array<double, 3>;
    using Key = std::array<Place, 3>;
    const auto key_of = [](std::span<const Vector3d> points, const Triangle& t) {
        Key key;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3d& p = points[static_cast<std::size_t>(t[k])];
            key[k] = {p.x(), p.y(), p.z()};
        }
        std::sort(key.begin(), key.end());
        return key;
    };
    std::vector<std::pair<Key, std::int32_t>> known;
    for (std::size_t f = 0; f < before.size(); ++f)
        known.emplace_back(key_of(points_before, before[f]), static_cast<std::int32_t>(f));
    std::sort(known.begin(), known.end());
    std::vector<std::int32_t> found;
    for (const Triangle& t : now) {
        const std::pair<Key, std::int32_t> wanted(key_of(points_now, t), -1);
        std::int32_t same = -1;
        for (auto at = std::lower_bound(known.begin(), known.end(), wanted); at != known.end() && at->first == wanted.first;
             ++at) {
            const bool of_these = std::is_permutation(t.begin(), t.end(), before[static_cast<std::size_t>(at->second)].begin());
            if (same < 0 || of_these) same = at->second;  // others are at these places where solids touch
        }
        found.push_back(same);
    }
    return found;
}

}  // namespace

void check_triangles(std::span<const Eigen::Vector3d> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    check_input(points, triangles);
}

std::vector<std::int32_t> mend_triangles(std::vector<Eigen::Vector3d>& points,
                                         std::vector<std::array<std::int32_t, 3>>& triangles,
                                         std::vector<std::vector<std::int32_t>>& lines) {
    std::vector<Source> along;
    for (std::vector<std::int32_t>& line : lines) along.push_back({std::move(line), {}, Sides::both});
    RepairResult repaired = repair_surface(points, triangles, along);
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = std::move(repaired.sources[i].vertices);
    std::vector<std::int32_t> before = same_triangles(points, triangles, repaired.points, repaired.triangles);
    points = std::move(repaired.points);
    triangles = std::move(repaired.triangles);
    return before;
}

}  // namespace anisoquad::cad
