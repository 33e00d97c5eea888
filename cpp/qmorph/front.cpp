#include "qmorph/front.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>

namespace anisoquad {

using M = SurfaceMesh;

namespace {

constexpr double kNearCut = 6.0;  ///< over the size

/// z · (cosine + i sine), the factor being of any length that is not zero, brought to a length near 1. (The operator of
/// std::complex looks for infinities.)
std::complex<double> turned(const std::complex<double>& z, double cosine, double sine) {
    const double size = std::max(std::abs(cosine), sine);
    if (!(size > 0.0)) return z;
    const double re = (z.real() * cosine - z.imag() * sine) / size;
    const double im = (z.real() * sine + z.imag() * cosine) / size;
    return {re, im};
}

}  // namespace

bool is_near_cut(const SurfaceMesh& mesh, HalfEdge h, const Cuts& cuts) {
    if (cuts.empty()) return false;
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.to(h);
    const double size = std::max({mesh.length(h), mesh.info(a).size, mesh.info(b).size});
    return cuts.is_near(0.5 * (mesh.position(a) + mesh.position(b)), kNearCut * size);
}

HalfEdge next_front(const SurfaceMesh& mesh, HalfEdge h) {
    HalfEdge out = mesh.next(h);
    while (!is_front(mesh, out)) out = mesh.next(M::twin(out));
    return out;
}

HalfEdge previous_front(const SurfaceMesh& mesh, HalfEdge h) {
    HalfEdge in = mesh.prev(h);
    while (!is_front(mesh, in)) in = mesh.prev(M::twin(in));
    return in;
}

double front_angle(const SurfaceMesh& mesh, HalfEdge h) {
    const Point& p = mesh.position(mesh.to(h));
    double sum = 0.0;
    HalfEdge in = h;
    while (true) {
        const HalfEdge out = mesh.next(in);
        const Eigen::Vector3d a = mesh.position(mesh.from(in)) - p;
        const Eigen::Vector3d b = mesh.position(mesh.to(out)) - p;
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
        if (is_front(mesh, out)) return sum;
        in = M::twin(out);
    }
}

bool is_front_angle_below(const SurfaceMesh& mesh, HalfEdge h, double limit) {
    // What the sum of the angles exceeds the limit by, as the direction of a complex number; each angle turns it by π at most.
    std::complex<double> excess = std::polar(1.0, -limit);
    const Point& p = mesh.position(mesh.to(h));
    HalfEdge in = h;
    while (true) {
        const HalfEdge out = mesh.next(in);
        const Eigen::Vector3d a = mesh.position(mesh.from(in)) - p;
        const Eigen::Vector3d b = mesh.position(mesh.to(out)) - p;
        excess = turned(excess, a.dot(b), a.cross(b).norm());
        if (excess.imag() >= 0.0) return false;
        if (is_front(mesh, out)) return true;
        in = M::twin(out);
    }
}

Eigen::Vector3d sector_normal(const SurfaceMesh& mesh, HalfEdge h) {
    const Point& p = mesh.position(mesh.to(h));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    HalfEdge in = h;
    while (true) {
        const HalfEdge out = mesh.next(in);
        sum += (mesh.position(mesh.to(out)) - p).cross(mesh.position(mesh.from(in)) - p);
        if (is_front(mesh, out)) return sum;
        in = M::twin(out);
    }
}

HalfEdge front_into(const SurfaceMesh& mesh, HalfEdge spoke) {
    // Counter-clockwise from the spoke the sector is bounded by the reverse of the front edge that ends at the node.
    HalfEdge out = spoke;
    do {
        const HalfEdge in = mesh.prev(out);
        if (is_front(mesh, in)) return in;
        out = M::twin(in);
    } while (out != spoke);
    return {};
}

FrontWay front_way(const SurfaceMesh& mesh, HalfEdge first, HalfEdge last, int limit) {
    FrontWay way{1, mesh.info(M::edge(last)).cut};
    for (HalfEdge h = first; h != last; h = next_front(mesh, h)) {
        if (++way.edges > limit || (way.edges > 2 && h == first)) return {-1, false};
        way.along_cut |= mesh.info(M::edge(h)).cut;
    }
    return way;
}

int loop_length(const SurfaceMesh& mesh, HalfEdge h, int limit) {
    int n = 1;
    for (HalfEdge k = next_front(mesh, h); k != h; k = next_front(mesh, k)) {
        if (++n > limit) return n;
    }
    return n;
}

}  // namespace anisoquad
