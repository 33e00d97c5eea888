#include "smoothing/line_smoothing.h"

#include <array>

#include "smoothing/pattern_search.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kStraight = 1e-6;
constexpr double kMargin = 0.2;  ///< least part of the way between the neighbours that is left on either side
constexpr double kFirstStep = 0.1;
constexpr double kSmallestStep = 1e-3;
constexpr double kLeastGain = 1e-6;

constexpr double kDeviation = 4e-5;  ///< of a line's edges from the input's line, in a frame where the model's diagonal is 1

/// The neighbours of a node that may slide on its line.
bool find_line_neighbours(const SurfaceMesh& mesh, Vertex v, std::array<Vertex, 2>& ends) {
    const VertexInfo& info = mesh.info(v);
    if (info.kind != NodeKind::line || info.in_row) return false;
    std::size_t count = 0;
    for (HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_constrained(SurfaceMesh::edge(h))) continue;
        if (count == 2 || mesh.info(SurfaceMesh::edge(h)).source) return false;
        ends[count++] = mesh.to(h);
    }
    return count == 2;
}

double score(const Star& star, const Point& p) { return star.quality(p).score(); }

}  // namespace

bool slide_on_line(SurfaceMesh& mesh, Vertex v) {
    std::array<Vertex, 2> ends;
    if (!find_line_neighbours(mesh, v, ends)) return false;
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
            if (s > best + kTie) {
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

bool slide_on_curve(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines) {
    std::array<Vertex, 2> ends;
    if (!find_line_neighbours(mesh, v, ends)) return false;
    Star star;
    if (!star.gather(mesh, v)) return false;
    star.use_face_normals();
    const double worst = star.quality(star.centre()).worst;
    if (worst >= Star::kPoor) return false;

    // Places of the neighbours so that low < here < high, on a closed line past its first node if need be.
    const std::int32_t line = mesh.info(v).line;
    const double here = lines.closest(line, star.centre());
    double low = lines.closest(line, mesh.position(ends[0]));
    double high = lines.closest(line, mesh.position(ends[1]));
    if (low > high) std::swap(low, high);
    if (!(low < here && here < high)) {
        if (!lines.is_closed(line)) return false;
        const double length = lines.length(line);
        if (here > high) std::swap(low, high), high += length;
        if (here < low) std::swap(low, high), low -= length;
        if (!(low < here && here < high)) return false;
    }
    const double margin = kMargin * (high - low);
    double best = score(star, star.centre());
    const double before = best;
    double place = here;
    for (double step = kFirstStep * (high - low); step >= kSmallestStep * (high - low);) {
        double found = place;
        for (const double trial : {place - step, place + step}) {
            if (trial < low + margin || trial > high - margin) continue;
            const double s = score(star, lines.at(line, trial));
            if (s <= best + kTie || star.quality(lines.at(line, trial)).worst < worst) continue;
            if (lines.deviation(line, low, trial) > kDeviation || lines.deviation(line, trial, high) > kDeviation) continue;
            best = s;
            found = trial;
        }
        if (found == place) step *= 0.5;
        place = found;
    }
    if (place == here || best < before + kLeastGain) return false;
    mesh.position(v) = lines.at(line, place);
    mesh.info(v).input = -1;
    return true;
}

}  // namespace anisoquad
