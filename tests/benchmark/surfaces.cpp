#include "surfaces.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <random>

namespace anisoquad::benchmarks {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

/// Every triangle becomes four, every edge of the leading edge two.
Surface divided(const Surface& s) {
    Surface result{s.points, {}, {}};
    std::map<Edge, std::int32_t> middle;
    const auto middle_of = [&](std::int32_t a, std::int32_t b) {
        const auto [place, is_new] = middle.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(result.points.size()));
        if (is_new)
            result.points.push_back(0.5 * (s.points[static_cast<std::size_t>(a)] + s.points[static_cast<std::size_t>(b)]));
        return place->second;
    };
    for (const auto& [a, b, c] : s.triangles) {
        const std::int32_t ab = middle_of(a, b);
        const std::int32_t bc = middle_of(b, c);
        const std::int32_t ca = middle_of(c, a);
        for (const std::array<std::int32_t, 3>& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            result.triangles.push_back(t);
    }
    for (std::size_t i = 0; i < s.leading_edge.size(); ++i) {
        if (i > 0) result.leading_edge.push_back(middle_of(s.leading_edge[i - 1], s.leading_edge[i]));
        result.leading_edge.push_back(s.leading_edge[i]);
    }
    return result;
}

}  // namespace

Surface plane(int triangles) {
    const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
    const double h = 1.0 / n;
    std::mt19937 random(7);
    const auto shift = [&] { return 0.2 * h * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0); };
    Surface s;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double dx = shift();
            const double dy = shift();
            s.points.emplace_back(i * h + (i > 0 && i < n ? dx : 0.0), j * h + (j > 0 && j < n ? dy : 0.0), 0.0);
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const std::int32_t a = j * (n + 1) + i;
            const std::int32_t b = a + 1;
            const std::int32_t c = a + n + 2;
            const std::int32_t d = a + n + 1;
            // The diagonals' directions are mixed: no pattern that a mesher could find.
            if (random() % 2 == 0) {
                s.triangles.push_back({a, b, c});
                s.triangles.push_back({a, c, d});
            } else {
                s.triangles.push_back({a, b, d});
                s.triangles.push_back({b, c, d});
            }
        }
    }
    return s;
}

Surface sphere(int triangles) {
    const double phi = 0.5 * (1.0 + std::sqrt(5.0));
    const std::vector<Eigen::Vector3d> corners{{-1, phi, 0}, {1, phi, 0}, {-1, -phi, 0}, {1, -phi, 0},
                                               {0, -1, phi}, {0, 1, phi}, {0, -1, -phi}, {0, 1, -phi},
                                               {phi, 0, -1}, {phi, 0, 1}, {-phi, 0, -1}, {-phi, 0, 1}};
    const std::vector<std::array<int, 3>> faces{
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 20.0))));
    Surface s;
    std::map<std::array<std::int64_t, 3>, std::int32_t> known;  // nodes on the icosahedron's edges are met from two faces
    const auto node = [&](const Eigen::Vector3d& p) {
        const Eigen::Vector3d grid = (p * 1e9).array().round();
        const auto [place, is_new] = known.try_emplace(
            {static_cast<std::int64_t>(grid.x()), static_cast<std::int64_t>(grid.y()), static_cast<std::int64_t>(grid.z())},
            static_cast<std::int32_t>(s.points.size()));
        if (is_new) s.points.push_back(p.normalized());
        return place->second;
    };
    for (const auto& f : faces) {
        const auto at = [&](int i, int j) {
            const Eigen::Vector3d& a = corners[static_cast<std::size_t>(f[0])];
            const Eigen::Vector3d& b = corners[static_cast<std::size_t>(f[1])];
            const Eigen::Vector3d& c = corners[static_cast<std::size_t>(f[2])];
            return node(((n - i - j) * a + i * b + j * c) / n);
        };
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i + j < n; ++i) {
                s.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 1 < n) s.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    }
    return s;
}

Surface wing(const std::string& name, int triangles) {
    Surface s = read_wing_file(ANISOQUAD_TEST_DATA "/" + name);
    while (static_cast<int>(s.triangles.size()) < triangles) s = divided(s);
    return s;
}

}  // namespace anisoquad::benchmarks
