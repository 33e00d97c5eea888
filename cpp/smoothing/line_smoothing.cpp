#include "smoothing/line_smoothing.h"

#include <array>

#include "smoothing/star.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kStraight = 1e-6;
constexpr double kMargin = 0.2;  ///< least part of the way between the neighbours that is left on either side
constexpr double kFirstStep = 0.1;
constexpr double kSmallestStep = 1e-3;
constexpr double kLeastGain = 1e-6;

double score(const Star& star, const Point& p) { return star.quality(p).score(); }

}  // namespace

bool slide_on_line(SurfaceMesh& mesh, Vertex v) {
    const VertexInfo& info = mesh.info(v);
    if (info.kind != NodeKind::line || info.in_row) return false;
    std::array<Vertex, 2> ends;
    std::size_t count = 0;
    for (HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_constrained(SurfaceMesh::edge(h))) continue;
        if (count == 2 || mesh.info(SurfaceMesh::edge(h)).source) return false;
        ends[count++] = mesh.to(h);
    }
    if (count != 2) return false;
    const Point& a = mesh.position(ends[0]);
    const Vector3d chord = mesh.position(ends[1]) - a;
    const Vector3d offset = mesh.position(v) - a;
    double t = offset.dot(chord) / chord.squaredNorm();
    if (!((offset - t * chord).norm() <= kStraight * chord.norm()) || !(t > 0.0 && t < 1.0)) return false;

    Star star;
    if (!star.gather(mesh, v)) return false;
    // Across a sharp line there is no common normal: every face must stay as it is turned now.
    star.use_face_normals();
    const double before = score(star, star.centre());
    double best = before;
    const double start = t;
    for (double step = kFirstStep; step >= kSmallestStep;) {
        double found = t;
        for (const double trial : {t - step, t + step}) {
            if (trial < kMargin || trial > 1.0 - kMargin) continue;
            const double s = score(star, a + trial * chord);
            if (s > best) {
                best = s;
                found = trial;
            }
        }
        if (found == t) step *= 0.5;
        t = found;
    }
    if (t == start || best < before + kLeastGain) return false;
    mesh.position(v) = a + t * chord;
    mesh.info(v).input = -1;
    return true;
}

}  // namespace anisoquad
