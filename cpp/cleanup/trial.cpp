#include "cleanup/trial.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "cleanup/facing.h"
#include "cleanup/folds.h"
#include "mesh/area_vector.h"
#include "quality/metrics.h"
#include "smoothing/laplacian.h"
#include "smoothing/move_node.h"
#include "smoothing/optimisation.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr int kMostEdges = 16;       ///< of a node that is optimised: the hub of a fan would cost more than all else together
constexpr int kMeanSweeps = 10;      ///< plain averaging of the new nodes, which untangles convex outlines
constexpr int kSweeps = 6;           ///< guarded: insets between lines need them
constexpr double kPoor = 0.7;        ///< scaled Jacobian below which a node's place is optimised
constexpr double kGoodEnough = 0.4;  ///< scaled Jacobian
constexpr double kUseless = 0.05;    ///< scaled Jacobian
constexpr double kAnyAspect = 20.0;  ///< for the repair of what is useless
constexpr double kAspectOfSlivers =
    1e6;  ///< for the repair of what is inverted: between lines that meet at a small angle all is slim
constexpr double kMadeUseful = 0.01;         ///< gain of the scaled Jacobian that counts as repair where it was useless
constexpr double kRepaired = 0.1;            ///< fall of the lack that counts as repair
constexpr double kMoreAspect = 1.5;          ///< for a repair
constexpr double kMoreAspectAtAPrice = 2.5;  ///< for one that is worth irregular nodes
constexpr double kLongestAspect = 3.0;       ///< stretched quads pass if there were such before
constexpr double kMeanLoss = 0.03;           ///< the mean scaled Jacobian may fall by this, which the final smoothing makes good
constexpr double kDistance = 5.1e-4;  ///< from the surface, over its diagonal, that passes in any case: more than project() lifts
constexpr double kDistanceUpright = 1.5e-3;  ///< the same for what leaves fewer inverted quads
constexpr double kCountChange = 0.1;         ///< share of the quads that may come or go, so that sizes are kept

}  // namespace

Trial::Trial(SurfaceMesh& mesh, const ReferenceSurface& reference)
    : mesh_(mesh), reference_(reference), sectors_(mesh, reference), editor_(mesh) {}

int Trial::gain(const Region& region, const Replacement& replacement) const {
    static thread_local std::vector<Vertex> corners;
    corners.clear();
    for (const auto& quad : replacement.quads) corners.insert(corners.end(), quad.begin(), quad.end());
    std::sort(corners.begin(), corners.end());
    const auto uses = [&](Vertex v) {
        const auto [first, last] = std::equal_range(corners.begin(), corners.end(), v);
        return static_cast<int>(last - first);
    };
    int gain = 0;
    for (const Vertex v : region.inner) gain += irregularity(mesh_.valence(v));
    for (std::size_t k = 0; k < replacement.nodes.size(); ++k) gain -= irregularity(uses(Replacement::new_node(k)));
    const std::size_t n = region.loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const HalfEdge h = region.loop[i];
        const HalfEdge last = M::twin(region.loop[(i + n - 1) % n]);
        int inside = 1;
        for (HalfEdge k = mesh_.rotated_ccw(h); k != last; k = mesh_.rotated_ccw(k)) ++inside;
        Sectors::Count count = sectors_.count(mesh_, h);
        gain += count.cost();
        count.quads += uses(mesh_.from(h)) - inside;
        gain -= count.cost();
    }
    return gain;
}

Trial::Quality Trial::quality(std::span<const Face> faces) {
    Quality result;
    result.folds = count_folds(mesh_, faces);
    result.mean = 0.0;
    std::array<Point, 4> p;
    for (const Face f : faces) {
        std::size_t k = 0;
        for (const HalfEdge h : mesh_.halfedges(f)) p[k++] = mesh_.position(mesh_.from(h));
        const std::int32_t patch = mesh_.info(f).patch;
        const Point centre = 0.25 * (p[0] + p[1] + p[2] + p[3]);
        const SurfacePoint middle = reference_.closest(centre, patch, hint_);
        hint_ = middle.facet;
        const Eigen::Vector3d area = (p[2] - p[0]).cross(p[3] - p[1]);
        const bool upright =
            area.dot(middle.normal) > 0.0 || area.dot(reference_.closest(centre, {patch, facing(mesh_, f)}, hint_).normal) > 0.0;
        const double q = scaled_jacobian(p[0], p[1], p[2], p[3]);
        const double judged = upright ? q : -std::abs(q);
        result.worst = std::min(result.worst, judged);
        result.inverted += judged <= kUpright ? 1 : 0;
        result.deficit += std::max(0.0, kUseless - judged);
        result.lack += std::max(0.0, kGoodEnough - judged);
        result.mean += q / static_cast<double>(faces.size());
        result.aspect = std::max(result.aspect, aspect_ratio(p[0], p[1], p[2], p[3]));
        result.distance = std::max(result.distance, middle.distance);
        for (const HalfEdge h : mesh_.halfedges(f)) {
            if (h.index() % 2 != 0) continue;  // inner edges once
            const Point m = 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
            result.distance = std::max(result.distance, reference_.closest(m, patch, middle.facet).distance);
        }
    }
    return result;
}

bool Trial::is_acceptable(const Quality& before, const Quality& after, const Demands& demands) const {
    const double distance = after.inverted < before.inverted ? kDistanceUpright : kDistance;
    if (after.distance > std::max(before.distance, distance * reference_.diagonal())) return false;
    if (after.worst < std::min(before.worst, demands.bound) || after.inverted > before.inverted) return false;
    if (after.folds > before.folds && !(demands.may_fold && after.inverted < before.inverted)) return false;
    if (demands.deficit > 0.0 && after.deficit > before.deficit - demands.deficit) return false;
    if (demands.nearer < 1.0)
        return after.distance <= demands.nearer * before.distance &&
               after.aspect <= kMoreAspect * std::max(before.aspect, kLongestAspect);
    // One of several useless elements may be mended before the others.
    // The count comes first: either alone would let two changes undo each other for ever.
    const bool fewer_useless =
        after.inverted != before.inverted ? after.inverted < before.inverted : after.deficit <= before.deficit - kMadeUseful;
    if (demands.improvement > 0.0 && !fewer_useless && after.worst < before.worst + demands.improvement &&
        after.lack > before.lack - demands.improvement)
        return false;
    // The repair of what is hardly usable is worth stretched quads; of what is not usable at all, any.
    if (fewer_useless) return after.aspect <= std::max(before.aspect, before.worst > kUpright ? kAnyAspect : kAspectOfSlivers);
    if (after.lack <= before.lack - kRepaired) {
        const double more = demands.gain < 0 ? kMoreAspectAtAPrice : kMoreAspect;
        return after.aspect <= more * std::max(before.aspect, kLongestAspect);
    }
    return after.aspect <= std::max(before.aspect, kLongestAspect) && after.mean >= before.mean - kMeanLoss;
}

void Trial::gather_neighbourhood(const Region& region, std::vector<Face>& faces) {
    marks_.clear(mesh_.face_slots());
    faces = region.faces;
    for (const Face f : faces) marks_.mark(f);
    for (const HalfEdge h : region.loop) {
        for (const HalfEdge k : mesh_.outgoing(mesh_.from(h))) {
            const Face f = mesh_.face(k);
            if (f.is_valid() && mesh_.is_quad(f) && mesh_.info(f).row == 0 && marks_.mark(f)) faces.push_back(f);
        }
    }
}

void Trial::smooth(const Region& region, const Sheet* sheet) {
    const ReferenceSurface* const surface = sheet ? &reference_ : nullptr;
    Point target;
    for (int i = 0; i < kMeanSweeps; ++i) {
        for (const Vertex v : region.inner) {
            if (!is_movable(mesh_, v) || !laplacian_target(mesh_, v, target)) continue;
            mesh_.position(v) = sheet ? reference_.project(target, *sheet, hint_) : target;
        }
    }
    const auto improve = [&](Vertex v, bool last) {
        if (!is_movable(mesh_, v)) return;
        if (laplacian_target(mesh_, v, target)) move_node(mesh_, v, target, surface, &hint_, kPoor);
        if (last && mesh_.valence(v) <= kMostEdges && worst_quality(mesh_, v, node_normal(mesh_, v)) < kPoor)
            optimise_node(mesh_, v, surface, &hint_);
    };
    for (int i = 0; i < kSweeps; ++i) {
        for (const Vertex v : region.inner) improve(v, i + 1 == kSweeps);
        for (const HalfEdge h : region.loop) improve(mesh_.from(h), i + 1 == kSweeps);
    }
}

void Trial::restore_outline() {
    for (const auto& [v, node] : places_) {
        mesh_.position(v) = node.place;
        mesh_.info(v) = node.info;
    }
}

bool Trial::attempt(Region& region, const Replacement& replacement, const Demands& demands) {
    if (!editor_.find_outline(region) || !editor_.is_possible(region, replacement)) return false;
    if (gain(region, replacement) < demands.gain) return false;
    const auto quads = static_cast<double>(region.faces.size());
    if (std::abs(static_cast<double>(replacement.quads.size()) - quads) > demands.count_change + kCountChange * quads)
        return false;
    gather_neighbourhood(region, faces_);
    const Quality before = quality(faces_);
    const Replacement back = editor_.current(region);
    places_.clear();
    for (const HalfEdge h : region.loop) {
        const Vertex v = mesh_.from(h);
        places_.push_back({v, {mesh_.position(v), mesh_.info(v)}});
    }
    Sheet sheet(mesh_.info(region.faces[0]).patch);
    for (const Face f : region.faces) sheet.up += doubled_area_vector_of_quad(mesh_, f);
    ++tries_;
    work_ += faces_.size();
    editor_.replace(region, replacement);
    smooth(region, &sheet);
    gather_neighbourhood(region, faces_);
    const Quality after = quality(faces_);
    if (is_acceptable(before, after, demands)) return true;
    restore_outline();
    if (demands.may_leave_surface && before.inverted > 0 && after.inverted > 0) {
        smooth(region, nullptr);
        const Quality inside = quality(faces_);
        if (inside.inverted < before.inverted && is_acceptable(before, inside, demands)) return true;
        restore_outline();
    }
    editor_.replace(region, back);
    return false;
}

}  // namespace anisoquad
