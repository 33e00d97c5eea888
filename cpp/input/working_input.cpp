#include "input/working_input.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "input/flatness.h"
#include "input/needles.h"
#include "input/slivers.h"
#include "input/spatial_order.h"
#include "mesh/arrays.h"
#include "release.h"

namespace anisoquad {
namespace {

std::array<std::int32_t, 3> nodes_of(const SurfaceMesh& mesh, Face triangle) {
    const HalfEdge h = mesh.halfedge(triangle);
    return {mesh.from(h).index(), mesh.to(h).index(), mesh.to(mesh.next(h)).index()};
}

std::array<std::int32_t, 3> lowest_first(std::array<std::int32_t, 3> triangle) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    return triangle;
}

}  // namespace

WorkingInput::WorkingInput(std::span<const Point> points, Triangles triangles, bool keep_order, const Context& context)
    : points_(points), triangles_(triangles) {
    const Eigen::AlignedBox3d box = bounding_box(points, triangles);
    centre_ = 0.5 * (box.min() + box.max());
    scale_ = box.diagonal().norm();
    if (!keep_order) put_triangles_in_order();
    context.breathe();
    unit_points_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        unit_points_.push_back((points[at(input_vertex(static_cast<std::int32_t>(i)))] - centre_) / scale_);
}

void WorkingInput::put_triangles_in_order() {
    SpatialOrder order = spatial_order(points_, triangles_);
    ordered_triangles_.reserve(triangles_.size());
    for (const std::int32_t f : order.triangle) {
        const auto& [a, b, c] = triangles_[at(f)];
        ordered_triangles_.push_back(lowest_first({order.rank[at(a)], order.rank[at(b)], order.rank[at(c)]}));
    }
    triangles_ = ordered_triangles_;
    vertex_ = std::move(order.vertex);
    rank_ = std::move(order.rank);
}

void WorkingInput::put_in_order(std::vector<Source>& sources, Options& options) {
    if (rank_.empty()) return;
    for (Source& source : sources) {
        for (std::int32_t& v : source.vertices) v = rank_[at(v)];
    }
    for (auto& [a, b] : options.feature_edges) {
        a = rank_[at(a)];
        b = rank_[at(b)];
    }
    release(rank_);
    if (options.vertex_size.empty()) return;
    const std::vector<double> sizes = std::move(options.vertex_size);
    options.vertex_size.clear();
    for (const std::int32_t v : vertex_) options.vertex_size.push_back(sizes[at(v)]);
}

int WorkingInput::collapse_needles_of(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options,
                                      const Context& context) {
    assert(!vertex_.empty());
    const int collapsed = collapse_needles(mesh, 1.0, sources, options);
    if (collapsed == 0) return 0;
    ordered_triangles_.clear();
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (!mesh.is_deleted(Face(i))) ordered_triangles_.push_back(lowest_first(nodes_of(mesh, Face(i))));
    }
    triangles_ = ordered_triangles_;
    mesh = from_arrays(unit_points_, triangles_, context);
    return collapsed;
}

std::size_t WorkingInput::turn_slivers_of(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options) {
    assert(!vertex_.empty());
    const std::vector<Face> changed = turn_slivers(mesh, 1.0, sources, options);
    for (const Face f : changed) ordered_triangles_[at(f.index())] = nodes_of(mesh, f);
    return changed.size();
}

Point WorkingInput::place_of(const SurfaceMesh& mesh, Vertex v) const {
    const std::int32_t input = input_vertex(mesh.info(v).input);
    return input >= 0 ? points_[at(input)] : Point(centre_ + scale_ * mesh.position(v));
}

void WorkingInput::release_arrays() {
    release(unit_points_);
    release(ordered_triangles_);
    triangles_ = {};
}

}  // namespace anisoquad
