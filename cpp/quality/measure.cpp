#include "quality/measure.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/area_vector.h"
#include "mesh/arrays.h"
#include "mesh/face_middle.h"
#include "mesh/validate.h"
#include "parallel.h"
#include "quality/distance.h"
#include "quality/metrics.h"
#include "quality/row_report.h"
#include "release.h"
#include "surface/reference_surface.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Value below which the share `q` of the sorted values lies, interpolated linearly.
double percentile(const std::vector<double>& sorted, double q) {
    if (sorted.empty()) return 0.0;
    const double place = q * static_cast<double>(sorted.size() - 1);
    const auto i = static_cast<std::size_t>(place);
    const double next = sorted[std::min(i + 1, sorted.size() - 1)];
    return sorted[i] + (place - static_cast<double>(i)) * (next - sorted[i]);
}

class Measurer {
  public:
    Measurer(const SurfaceMesh& mesh, const ReferenceSurface& reference, Report& report, const Context& context)
        : mesh_(mesh), reference_(reference), report_(report), context_(context), arrays_(to_arrays(mesh)) {
        for (std::size_t i = 0; i < arrays_.faces.size(); ++i) {
            if (arrays_.faces[i][3] >= 0) quads_.push_back(i);
        }
    }

    void run(std::int32_t euler_in, std::span<const Source> sources) {
        report_.euler_in = euler_in;
        count_elements();
        context_.report(0.1);
        measure_quality();
        context_.report(0.3);
        count_inverted();
        context_.breathe();
        measure_corners();
        context_.report(0.4);
        count_valences();
        context_.breathe();
        compare_row_ends();
        report_.rows = measure_rows(mesh_, sources);
        context_.report(0.5);
        measure_distance();
        context_.report(0.9);
    }

  private:
    Face face(std::size_t i) const { return arrays_.face_handles[i]; }

    void count_elements() {
        const auto as_count = [](std::size_t n) { return static_cast<std::int32_t>(n); };
        report_.triangles_in = reference_.facet_count();
        report_.quads = as_count(quads_.size());
        report_.nodes = as_count(arrays_.points.size());
        report_.triangles_left = as_count(arrays_.faces.size() - quads_.size());
        report_.reduction_percent =
            report_.triangles_in == 0 ? 0.0 : 100.0 * (1.0 - static_cast<double>(report_.quads) / report_.triangles_in);
        const Topology topology_out = topology(mesh_);
        report_.components = topology_out.components;
        report_.euler_out = topology_out.euler_characteristic;
    }

    /// @param measure (mesh, face) → value
    template <class Measure>
    Distribution distribution(Measure measure, bool small_is_bad) {
        context_.breathe();
        Distribution result;
        values_.resize(quads_.size());
        for_each(static_cast<std::int32_t>(quads_.size()),
                 [&](std::int32_t i) { values_[at(i)] = measure(face(quads_[at(i)])); });
        double worst = 0.0;
        for (std::size_t i = 0; i < quads_.size(); ++i) {
            if (result.worst >= 0 && !(small_is_bad ? values_[i] < worst : values_[i] > worst)) continue;
            worst = values_[i];
            result.worst = static_cast<std::int32_t>(quads_[i]);
        }
        std::erase_if(values_, [](double value) { return !std::isfinite(value); });
        if (values_.empty()) return result;
        tbb::parallel_sort(values_.begin(), values_.end());
        double sum = 0.0;
        for (const double value : values_) sum += value;
        result.min = values_.front();
        result.p5 = percentile(values_, 0.05);
        result.mean = sum / static_cast<double>(values_.size());
        result.p95 = percentile(values_, 0.95);
        result.max = values_.back();
        return result;
    }

    void measure_quality() {
        report_.scaled_jacobian = distribution([&](Face f) { return scaled_jacobian(mesh_, f); }, true);
        report_.aspect_ratio = distribution([&](Face f) { return aspect_ratio(mesh_, f); }, false);
        report_.min_angle = distribution([&](Face f) { return min_angle(mesh_, f); }, true);
        report_.max_angle = distribution([&](Face f) { return max_angle(mesh_, f); }, false);
        report_.skew = distribution([&](Face f) { return skew(mesh_, f); }, false);
        report_.warpage = distribution([&](Face f) { return warpage(mesh_, f); }, false);
    }

    /// Folded quads, those with a corner of 180°, and those turned over as a whole: against the surface below them and against a
    /// neighbour. The neighbour is asked too because on a thin body the closest facet can be one of the other side.
    void count_inverted() {
        const auto of_block = [&](std::int32_t first, std::int32_t last) {
            std::int32_t inverted = 0;
            std::int32_t hint = -1;
            for (std::int32_t i = first; i < last; ++i) inverted += is_inverted(face(quads_[at(i)]), hint) ? 1 : 0;
            return inverted;
        };
        report_.inverted = reduce_blocks(static_cast<std::int32_t>(quads_.size()), context_, 0, of_block, std::plus<>());
    }

    /// @param hint facet near the quad; receives the one below it where the neighbours leave a doubt
    bool is_inverted(Face f, std::int32_t& hint) const {
        if (!(scaled_jacobian(mesh_, f) > kLeastUpright)) return true;
        const Vector3d normal = doubled_area_vector_of_quad(mesh_, f);
        bool against_neighbour = false;
        for (const HalfEdge h : mesh_.halfedges(f)) {
            const Face other = mesh_.face(M::twin(h));
            against_neighbour |= !mesh_.is_constrained(M::edge(h)) && normal.dot(doubled_area_vector_of_quad(mesh_, other)) < 0.0;
        }
        if (!against_neighbour) return false;
        const SurfacePoint below = reference_.closest(face_middle(mesh_, f), ReferenceSurface::kAnyPatch, hint);
        hint = below.facet;
        return normal.dot(below.normal) < 0.0;
    }

    /// Angle (degrees) of the face of twin(h) at from(h), between h and the next half-edge clockwise.
    double corner_angle(HalfEdge h) const {
        const Point& p = mesh_.position(mesh_.from(h));
        const Vector3d u = mesh_.position(mesh_.to(h)) - p;
        const Vector3d v = mesh_.position(mesh_.to(mesh_.rotated_cw(h))) - p;
        return std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::numbers::pi;
    }

    /// Calls f(angle, faces, face) for every sector of a patch between neighbouring constrained edges at the node.
    template <class Function>
    void for_sectors(Vertex v, Function f) const {
        HalfEdge first;
        int lines = 0;
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (!mesh_.is_constrained(M::edge(h))) continue;
            ++lines;
            first = h;
        }
        if (lines < 2) return;
        HalfEdge h = first;
        do {
            double angle = 0.0;
            int faces = 0;
            bool outside = false;
            Face last;
            do {
                last = mesh_.face(M::twin(h));
                outside |= !last.is_valid();
                angle += corner_angle(h);
                ++faces;
                h = mesh_.rotated_cw(h);
            } while (!mesh_.is_constrained(M::edge(h)));
            if (!outside) f(angle, faces, last);
        } while (h != first);
    }

    void measure_corners() {
        double sharpest = 180.0;
        constexpr double kNoLimit = 2.0;
        std::vector<double> limit(at(mesh_.face_slots()), kNoLimit);  // sine of the feature corner that a quad fills alone
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            if (mesh_.is_deleted(Vertex(i))) continue;
            for_sectors(Vertex(i), [&](double angle, int faces, Face f) {
                sharpest = std::min(sharpest, angle);
                if (faces > 1 || angle >= 90.0) return;
                limit[at(f.index())] = std::min(limit[at(f.index())], std::sin(angle * std::numbers::pi / 180.0));
            });
        }
        report_.sharpest_corner = sharpest;
        report_.scaled_jacobian_limit = sharpest < 90.0 ? std::sin(sharpest * std::numbers::pi / 180.0) : 1.0;

        // Corner quads count too unless their limit is below the minimum over all the quads that count.
        struct CornerQuad {
            double limit;
            double value;
        };
        std::vector<CornerQuad> corner_quads;
        double elsewhere = std::numeric_limits<double>::infinity();
        for (const std::size_t i : quads_) {
            const double value = scaled_jacobian(mesh_, face(i));
            const double most = limit[at(face(i).index())];
            if (most < kNoLimit) {
                corner_quads.push_back({most, value});
            } else {
                elsewhere = std::min(elsewhere, value);
            }
        }
        std::sort(corner_quads.begin(), corner_quads.end(),
                  [](const CornerQuad& a, const CornerQuad& b) { return a.limit > b.limit; });
        for (const CornerQuad& quad : corner_quads) {
            if (std::isfinite(elsewhere) && quad.limit < elsewhere) break;
            elsewhere = std::min(elsewhere, quad.value);
        }
        report_.scaled_jacobian_min_elsewhere = std::isfinite(elsewhere) ? elsewhere : 0.0;
    }

    void count_valences() {
        std::int32_t interior = 0;
        report_.valence_histogram.clear();
        for (const Vertex v : arrays_.vertices) {
            if (mesh_.is_boundary(v)) continue;
            const auto valence = at(mesh_.valence(v));
            if (report_.valence_histogram.size() <= valence) report_.valence_histogram.resize(valence + 1, 0);
            ++report_.valence_histogram[valence];
            ++interior;
        }
        const std::int32_t regular = report_.valence_histogram.size() > 4 ? report_.valence_histogram[4] : 0;
        report_.regular_percent = interior > 0 ? 100.0 * regular / interior : 100.0;
    }

    void compare_row_ends() {
        values_.clear();
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            const Edge e(i);
            if (mesh_.is_deleted(e) || mesh_.is_constrained(e)) continue;  // beyond a line another patch has sizes of its own
            const Face f = mesh_.face(M::halfedge(e, 0));
            const Face g = mesh_.face(M::halfedge(e, 1));
            if ((mesh_.info(f).row > 0) == (mesh_.info(g).row > 0) || !mesh_.is_quad(f) || !mesh_.is_quad(g)) continue;
            const double a = area(mesh_, f);
            const double b = area(mesh_, g);
            if (std::min(a, b) > 0.0) values_.push_back(std::max(a, b) / std::min(a, b));
        }
        std::sort(values_.begin(), values_.end());
        report_.neighbour_area_ratio_p95 = values_.empty() ? 1.0 : percentile(values_, 0.95);
        report_.neighbour_area_ratio_max = values_.empty() ? 1.0 : values_.back();
    }

    /// The last of the measures: what the others needed is given back, since a second tree needs much room.
    void measure_distance() {
        std::vector<std::array<std::int32_t, 3>> halves;
        halves.reserve(2 * arrays_.faces.size());
        for (const auto& f : arrays_.faces) {
            halves.push_back({f[0], f[1], f[2]});
            if (f[3] >= 0) halves.push_back({f[0], f[2], f[3]});
        }
        std::vector<Point> points = std::move(arrays_.points);
        arrays_ = {};
        release(quads_);
        release(values_);
        const FacetTree result(std::move(points), halves, {}, context_);
        const double out = distance_to(reference_.tree(), result, context_);
        const double back = distance_to(result, reference_.tree(), context_);
        report_.hausdorff = std::max(out, back);
        report_.hausdorff_relative = report_.hausdorff / reference_.diagonal();
    }

    const SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    Report& report_;
    const Context& context_;
    MeshArrays arrays_;
    std::vector<std::size_t> quads_;  ///< places in arrays_.faces
    std::vector<double> values_;
};

}  // namespace

void measure(const SurfaceMesh& result, const ReferenceSurface& reference, std::int32_t euler_in, Report& report,
             std::span<const Source> sources, const Context& context) {
    Measurer(result, reference, report, context).run(euler_in, sources);
}

}  // namespace anisoquad
