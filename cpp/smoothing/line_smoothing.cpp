#include "smoothing/line_smoothing.h"

#include <array>
#include <limits>

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

/// A node's place on its line between those of its neighbours, low < here < high; on a closed line past its first node if need
/// be.
struct LineStretch {
    std::int32_t line = -1;
    double low = 0.0;
    double here = 0.0;
    double high = 0.0;
};

bool find_stretch(const SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines, LineStretch& s) {
    std::array<Vertex, 2> ends;
    if (!find_line_neighbours(mesh, v, ends)) return false;
    s.line = mesh.info(v).line;
    s.here = lines.closest(s.line, mesh.position(v));
    s.low = lines.closest(s.line, mesh.position(ends[0]));
    s.high = lines.closest(s.line, mesh.position(ends[1]));
    if (s.low > s.high) std::swap(s.low, s.high);
    if (s.low < s.here && s.here < s.high) return true;
    if (!lines.is_closed(s.line)) return false;
    const double length = lines.length(s.line);
    if (s.here > s.high) std::swap(s.low, s.high), s.high += length;
    if (s.here < s.low) std::swap(s.low, s.high), s.low -= length;
    return s.low < s.here && s.here < s.high;
}

/// The node's star, every face seen as it is turned now: across a sharp line there is no common normal.
bool gather_on_line(const SurfaceMesh& mesh, Vertex v, Star& star) {
    std::array<Vertex, 2> ends;
    if (!find_line_neighbours(mesh, v, ends) || !star.gather(mesh, v)) return false;
    star.use_face_normals();
    return true;
}

/// Where on its stretch the node scores best, with edges that leave the line by no more than a deviation.
/// @param score callable, place in space → double @param from the node's place in space
/// @returns `here` where no place is better
template <class Score>
double best_place(const Score& score, const ReferenceLines& lines, const LineStretch& s, double deviation, const Point& from) {
    const double margin = kMargin * (s.high - s.low);
    const double before = score(from);
    double best = before;
    double place = s.here;
    for (double step = kFirstStep * (s.high - s.low); step >= kSmallestStep * (s.high - s.low);) {
        double found = place;
        for (const double trial : {place - step, place + step}) {
            if (trial < s.low + margin || trial > s.high - margin) continue;
            const double value = score(lines.at(s.line, trial));
            if (value <= best + kTie) continue;
            if (lines.deviation(s.line, s.low, trial) > deviation || lines.deviation(s.line, trial, s.high) > deviation) continue;
            best = value;
            found = trial;
        }
        if (found == place) step *= 0.5;
        place = found;
    }
    return best < before + kLeastGain ? s.here : place;
}

/// What places of a node are worth that make no element worse than the worst one is with the node at `from`.
auto score_of_star(const Star& star, const Point& from) {
    return [&star, worst = star.quality(from).worst](const Point& p) {
        return star.quality(p).worst < worst ? -std::numeric_limits<double>::infinity() : score(star, p);
    };
}

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
    const Star::Quality old = star.quality(star.centre());
    const double before = old.score();
    const double least = std::min(old.worst, Star::kPoor);
    double best = before;
    const double start = t;
    for (double step = kFirstStep; step >= kSmallestStep;) {
        double found = t;
        for (const double trial : {t - step, t + step}) {
            if (trial < kMargin || trial > 1.0 - kMargin) continue;
            const Star::Quality q = star.quality(a + trial * chord);
            if (q.score() > best + kTie && q.worst >= least) {
                best = q.score();
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
    Star star;
    if (!gather_on_line(mesh, v, star) || star.quality(star.centre()).worst >= Star::kPoor) return false;
    return slide_on_curve_towards(mesh, v, lines, score_of_star(star, star.centre()));
}

bool slide_on_curve_towards(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines,
                            const std::function<double(const Point&)>& score) {
    LineStretch stretch;
    if (!find_stretch(mesh, v, lines, stretch)) return false;
    const double place = best_place(score, lines, stretch, kDeviation, mesh.position(v));
    if (place == stretch.here) return false;
    mesh.position(v) = lines.at(stretch.line, place);
    mesh.info(v).input = -1;
    return true;
}

bool slide_on_target(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines, const FramedTarget& target) {
    LineStretch stretch;
    Star star;
    if (!gather_on_line(mesh, v, star) || !find_stretch(mesh, v, lines, stretch)) return false;
    const double deviation = std::max({kDeviation, lines.deviation(stretch.line, stretch.low, stretch.here),
                                       lines.deviation(stretch.line, stretch.here, stretch.high)});
    const Point here = lines.at(stretch.line, stretch.here);
    const double place = best_place(score_of_star(star, here), lines, stretch, deviation, here);
    if (place == stretch.here) return false;
    const ReferenceLines::EdgePlace on = lines.edge_at(stretch.line, place);
    Point p = lines.at(stretch.line, place);
    const TargetPlace there{-1, Vector3d::Zero(), on.edge, on.share};
    target.project(std::span(&there, 1), std::span(&p, 1));
    const Star::Quality before = star.quality(star.centre());
    const Star::Quality after = star.quality(p);
    if (!p.allFinite() || after.score() < before.score() + kLeastGain || after.worst < std::min(before.worst, Star::kPoor))
        return false;
    mesh.position(v) = p;
    mesh.info(v).input = -1;
    return true;
}

}  // namespace anisoquad
