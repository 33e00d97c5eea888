#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesh/arrays.h"
#include "mesh/euler_operators.h"
#include "quality/metrics.h"
#include "surface/reference_surface.h"

/// Quad grids on surfaces for the tests of the smoothers.
namespace anisoquad::quad_grid {

inline Point on_plane(double x, double y) { return {x, y, 0.0}; }
inline Point on_sphere(double x, double y) { return Point(x - 0.5, y - 0.5, 0.8).normalized(); }
inline Point on_cylinder(double x, double y) { return {-std::cos(2.0 * x), 2.0 * y, std::sin(2.0 * x)}; }

using Map = Point (*)(double, double);

/// Name of a test on one of them.
inline std::string name_of(const testing::TestParamInfo<Map>& info) {
    return info.param == &on_plane ? "plane" : info.param == &on_sphere ? "sphere" : "cylinder";
}

struct Grid {
    int nx = 0;
    int ny = 0;
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;

    Vertex vertex(int i, int j) const { return Vertex(j * (nx + 1) + i); }

    /// The grid's squares as quads of patch 0; its border is feature line 0 with a corner at each end.
    SurfaceMesh mesh() const {
        SurfaceMesh m = from_arrays(points, triangles);
        for (std::size_t k = 0; k < triangles.size(); k += 2) {
            dissolve_edge(m, SurfaceMesh::edge(m.find_halfedge(Vertex(triangles[k][0]), Vertex(triangles[k][2]))));
        }
        for (std::int32_t f = 0; f < m.face_slots(); ++f) {
            if (!m.is_deleted(Face(f))) m.info(Face(f)).patch = 0;
        }
        for (std::int32_t e = 0; e < m.edge_slots(); ++e) {
            if (!m.is_deleted(Edge(e)) && m.is_boundary(Edge(e))) m.info(Edge(e)).line = 0;
        }
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                const bool side = i == 0 || i == nx;
                const bool end = j == 0 || j == ny;
                m.info(vertex(i, j)).kind = side && end ? NodeKind::corner : (side || end ? NodeKind::line : NodeKind::interior);
                if (side || end) m.info(vertex(i, j)).line = 0;
            }
        }
        return m;
    }
    ReferenceSurface reference() const { return ReferenceSurface(points, triangles); }
};

/// nx × ny quads over [0, 1]², mapped. (i, j) ↦ (x, y) may be replaced, for stretched grids.
template <class Map, class Place>
Grid make(int nx, int ny, Map map, Place place) {
    Grid g{nx, ny, {}, {}};
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            const auto [x, y] = place(i, j);
            g.points.push_back(map(x, y));
        }
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const std::int32_t a = j * (nx + 1) + i;
            g.triangles.push_back({a, a + 1, a + nx + 2});
            g.triangles.push_back({a, a + nx + 2, a + nx + 1});
        }
    }
    return g;
}

template <class Map>
Grid make(int nx, int ny, Map map) {
    return make(nx, ny, map, [&](int i, int j) { return std::pair(double(i) / nx, double(j) / ny); });
}

/// Moves the interior nodes of the mesh at random, by up to `amount` of the spacing in both directions of the grid's plane.
template <class Map>
void distort(SurfaceMesh& mesh, const Grid& g, Map map, double amount, unsigned seed = 5) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-amount, amount);
    for (int j = 1; j < g.ny; ++j) {
        for (int i = 1; i < g.nx; ++i) {
            const double x = (i + jitter(random)) / g.nx;
            const double y = (j + jitter(random)) / g.ny;
            mesh.position(g.vertex(i, j)) = map(x, y);
        }
    }
}

struct Quality {
    double min = 1.0;
    double mean = 0.0;
};

inline Quality quality(const SurfaceMesh& mesh) {
    Quality q;
    int n = 0;
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) {
        if (mesh.is_deleted(Face(f)) || !mesh.is_quad(Face(f))) continue;
        const double s = scaled_jacobian(mesh, Face(f));
        q.min = std::min(q.min, s);
        q.mean += s;
        ++n;
    }
    q.mean /= n;
    return q;
}

}  // namespace anisoquad::quad_grid
