#include "generated/kinds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "mesh/euler_operators.h"

namespace anisoquad::generated {
namespace {

using shapes::Shape;
using M = SurfaceMesh;

/// A count from low to high, or to the share of the way that the extent says.
int count(ByteSource& source, int low, int high, double extent) {
    return source.between(low, low + static_cast<int>(extent * (high - low) + 0.5));
}

Shape to_shape(const SurfaceMesh& mesh) {
    Shape shape;
    const MeshArrays arrays = to_arrays(mesh);
    shape.points = arrays.points;
    for (const auto& f : arrays.faces) shape.triangles.push_back({f[0], f[1], f[2]});
    return shape;
}

Shape make_grid(ByteSource& source, double extent) {
    const int nx = count(source, 1, 12, extent);
    const int ny = count(source, 1, 10, extent);
    const int holes = source.below(4) * source.below(3);
    std::vector<char> gone(static_cast<std::size_t>(nx * ny), 0);
    for (int i = 0; i < holes; ++i) gone[static_cast<std::size_t>(source.below(nx * ny))] = 1;
    return shapes::grid_with_holes(
        nx, ny, [&](int i, int j) { return !gone[static_cast<std::size_t>(j * nx + i)]; }, 2.0 / nx, 2.0 / ny);
}

/// A band around z whose radius changes linearly, down to a tip.
Shape make_cone(ByteSource& source, double extent) {
    const int n = count(source, 3, 24, extent);
    const int m = count(source, 1, 6, extent);
    const double top = source.one_in(2) ? source.fraction() : 1.0;
    const double height = 0.05 + 6.0 * source.fraction();
    Shape shape = shapes::cylinder(n, m, 1.0, height);
    for (Point& p : shape.points) p.head<2>() *= 1.0 + (std::max(top, 0.02) - 1.0) * p.z() / height;
    if (!source.one_in(2)) return shape;
    const auto tip = static_cast<std::int32_t>(shape.points.size());
    shape.points.emplace_back(0.0, 0.0, height * (1.0 + source.fraction()));
    for (int i = 0; i < n; ++i) shape.triangles.push_back({m * n + i, m * n + (i + 1) % n, tip});
    return shape;
}

Shape make_round(ByteSource& source, double extent) {
    const int n = count(source, 3, 18, extent);
    const int m = count(source, 3, 9, extent);
    if (source.one_in(2)) return shapes::torus(n, m, 1.0, 0.1 + 0.6 * source.fraction());
    return shapes::sphere(n, m);
}

Shape make_box(ByteSource& source, double extent) {
    const int n = count(source, 1, 4, extent);
    return shapes::placed(shapes::cube(n), 2.0 / n, Point(-1, -1, -1));
}

/// The skin of a set of cubes.
Shape make_cubes(ByteSource& source) {
    constexpr int kSide = 3;
    std::array<std::array<std::array<bool, kSide + 2>, kSide + 2>, kSide + 2> full{};
    for (std::size_t z = 1; z <= 2; ++z) {
        for (std::size_t y = 1; y <= kSide; ++y) {
            const int row = source.byte();
            for (std::size_t x = 1; x <= kSide; ++x) full[z][y][x] = (row >> x) & 1;
        }
    }
    Shape shape;
    std::map<std::array<std::size_t, 3>, std::int32_t> nodes;
    const auto node = [&](const std::array<std::size_t, 3>& p) {
        const auto [place, is_new] = nodes.emplace(p, static_cast<std::int32_t>(shape.points.size()));
        if (is_new) shape.points.emplace_back(p[0] - 2.0, p[1] - 2.0, p[2] - 2.0);
        return place->second;
    };
    for (std::size_t z = 1; z <= kSide; ++z) {
        for (std::size_t y = 1; y <= kSide; ++y) {
            for (std::size_t x = 1; x <= kSide; ++x) {
                if (!full[z][y][x]) continue;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    for (const std::size_t high : {0u, 1u}) {
                        std::array<std::size_t, 3> beside{z, y, x};
                        beside[2 - axis] += high ? 1u : static_cast<std::size_t>(-1);
                        if (full[beside[0]][beside[1]][beside[2]]) continue;
                        const std::size_t u = (axis + (high ? 1 : 2)) % 3;
                        const std::size_t v = (axis + (high ? 2 : 1)) % 3;
                        const auto corner = [&](std::size_t du, std::size_t dv) {
                            std::array<std::size_t, 3> p{x, y, z};
                            p[axis] += high;
                            p[u] += du;
                            p[v] += dv;
                            return node(p);
                        };
                        shape.add_quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), (x + y + z) % 2 == 1);
                    }
                }
            }
        }
    }
    return shape;
}

/// n triangles round a node, open or closed, flat or pointed.
Shape make_fan(ByteSource& source, double extent) {
    const int n = count(source, 1, 70, extent);
    const double height = source.one_in(2) ? 4.0 * source.fraction() : 0.0;
    const bool closed = n >= 3 && source.one_in(2);
    const double turn = closed ? 2.0 * std::numbers::pi : std::min(6.0, n * (0.02 + 1.2 * source.fraction()));
    Shape shape;
    shape.points.emplace_back(0.0, 0.0, height);
    for (int i = 0; i < n + !closed; ++i) {
        const double angle = turn * i / n;
        shape.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    for (int i = 0; i < n; ++i) shape.triangles.push_back({0, 1 + i, 1 + (closed ? (i + 1) % n : i + 1)});
    return shape;
}

/// One triangle beside the other in a zigzag.
Shape make_strip(ByteSource& source, double extent) {
    const int n = count(source, 1, 20, extent);
    const double width = 0.01 + source.fraction();
    Shape shape;
    for (int i = 0; i < n + 2; ++i) shape.points.emplace_back(0.2 * i, i % 2 ? width : 0.0, 0.0);
    for (int i = 0; i < n; ++i) {
        if (i % 2) {
            shape.triangles.push_back({i, i + 2, i + 1});
        } else {
            shape.triangles.push_back({i, i + 1, i + 2});
        }
        if (i % 2 == 0) std::swap(shape.triangles.back()[1], shape.triangles.back()[2]);
    }
    return shape;
}

bool is_convex(const SurfaceMesh& mesh, Edge e) {
    const HalfEdge h = M::halfedge(e);
    const Point& a = mesh.position(mesh.from(h));
    const Point& b = mesh.position(mesh.to(h));
    const Point& l = mesh.position(mesh.to(mesh.next(h)));
    const Point& r = mesh.position(mesh.to(mesh.next(M::twin(h))));
    const Eigen::Vector3d n = (b - a).cross(l - a) + (r - a).cross(b - a);
    return (r - a).cross(l - a).dot(n) > 0.0 && (l - b).cross(r - b).dot(n) > 0.0;
}

/// A triangulation grown by splits and flips.
Shape make_random_triangulation(ByteSource& source, double extent) {
    SurfaceMesh mesh = shapes::placed(shapes::grid(1, source.between(1, 3)), 1.0, Point(-0.5, -0.5, 0.0)).mesh();
    const int steps = count(source, 1, 90, extent * extent);
    for (int i = 0; i < steps; ++i) {
        const int what = source.below(4);
        if (what == 0) {
            const Face f(source.below(mesh.face_slots()));
            std::array<double, 3> w{0.1 + source.fraction(), 0.1 + source.fraction(), 0.1 + source.fraction()};
            Point p = Point::Zero();
            std::size_t k = 0;
            for (const HalfEdge h : mesh.halfedges(f)) p += w[k++] * mesh.position(mesh.from(h));
            split_face(mesh, f, p / (w[0] + w[1] + w[2]));
            continue;
        }
        const Edge e(source.below(mesh.edge_slots()));
        if (what == 1) {
            const HalfEdge h = M::halfedge(e);
            const double t = 0.05 + 0.9 * source.fraction();
            split_edge(mesh, e, (1.0 - t) * mesh.position(mesh.from(h)) + t * mesh.position(mesh.to(h)));
        } else if (is_flip_ok(mesh, e) && is_convex(mesh, e)) {
            flip(mesh, e);
        }
    }
    return to_shape(mesh);
}

Shape read_off(const std::string& path) {
    std::ifstream file(path);
    std::string word;
    Shape shape;
    std::size_t points = 0;
    std::size_t facets = 0;
    file >> word >> points >> facets >> word;
    for (std::size_t i = 0; i < points; ++i) {
        Point p;
        file >> p.x() >> p.y() >> p.z();
        shape.points.push_back(p);
    }
    for (std::size_t i = 0; i < facets; ++i) {
        std::array<std::int32_t, 3> t{};
        file >> word >> t[0] >> t[1] >> t[2];
        shape.triangles.push_back(t);
    }
    return shape;
}

/// The facets around one of the wing.
Shape make_piece(ByteSource& source, double extent) {
    static const SurfaceMesh wing = read_off(std::string(ANISOQUAD_TEST_DATA) + "/wing_delta.off").mesh();
    const Face seed(source.below(std::min(wing.face_slots(), 65536)));
    const std::size_t size = static_cast<std::size_t>(count(source, 1, 200, extent * extent));
    std::vector<Face> faces{seed};
    for (std::size_t i = 0; i < faces.size() && faces.size() < size; ++i) {
        for (const HalfEdge h : wing.halfedges(faces[i])) {
            const Face g = wing.face(M::twin(h));
            if (g.is_valid() && std::find(faces.begin(), faces.end(), g) == faces.end() && !source.one_in(16)) faces.push_back(g);
        }
    }
    Shape shape;
    std::map<Vertex, std::int32_t> nodes;
    for (const Face f : faces) {
        std::array<std::int32_t, 3> t{};
        std::size_t k = 0;
        for (const HalfEdge h : wing.halfedges(f)) {
            const auto [place, is_new] = nodes.emplace(wing.from(h), static_cast<std::int32_t>(shape.points.size()));
            if (is_new) shape.points.push_back(wing.position(wing.from(h)));
            t[k++] = place->second;
        }
        shape.triangles.push_back(t);
    }
    return shape;
}

}  // namespace

Shape make_kind(ByteSource& source, double extent) {
    switch (source.below(10)) {
        case 0: return make_grid(source, extent);
        case 1: return make_cone(source, extent);
        case 2: return make_round(source, extent);
        case 3: return make_box(source, extent);
        case 4: return make_cubes(source);
        case 5: return make_fan(source, extent);
        case 6: return make_strip(source, extent);
        case 7: return make_piece(source, extent);
        case 8: return make_grid(source, extent);
        default: return make_random_triangulation(source, extent);
    }
}

}  // namespace anisoquad::generated
