#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;
using py::literals::operator""_a;

namespace anisoquad {
namespace {

py::dict to_dict(const Distribution& d) {
    return py::dict("min"_a = d.min, "p5"_a = d.p5, "mean"_a = d.mean, "p95"_a = d.p95, "max"_a = d.max, "worst"_a = d.worst);
}

py::dict to_dict(const PassReport& p) {
    return py::dict("source"_a = p.source, "pass"_a = p.pass, "side"_a = p.side, "ratio"_a = p.ratio, "rows"_a = p.rows,
                    "columns"_a = p.columns, "stopped"_a = p.stopped);
}

py::dict to_dict(const RowReport& r) {
    return py::dict("source"_a = r.source, "side"_a = r.side, "row"_a = r.row, "pass"_a = r.pass, "quads"_a = r.quads,
                    "aspect_mean"_a = r.aspect_mean, "height_mean"_a = r.height_mean);
}

py::dict to_dict(const StageTime& t) { return py::dict("stage"_a = t.stage, "seconds"_a = t.seconds); }

py::dict to_dict(const RepairReport& r) {
    return py::dict("out_of_range_facets"_a = r.out_of_range_facets, "non_finite_facets"_a = r.non_finite_facets,
                    "degenerate_facets"_a = r.degenerate_facets, "duplicate_facets"_a = r.duplicate_facets,
                    "welded_vertices"_a = r.welded_vertices, "cut_edges"_a = r.cut_edges, "flipped_facets"_a = r.flipped_facets,
                    "new_vertices"_a = r.new_vertices);
}

template <class Item>
py::list to_list(const std::vector<Item>& items) {
    py::list list;
    for (const Item& item : items) list.append(to_dict(item));
    return list;
}

}  // namespace

py::dict to_dict(const Report& r) {
    // One call a group: a single call with every field would need very deep templates.
    py::dict dict("triangles_in"_a = r.triangles_in, "quads"_a = r.quads, "nodes"_a = r.nodes,
                  "triangles_left"_a = r.triangles_left, "components"_a = r.components, "patches"_a = r.patches,
                  "feature_lines"_a = r.feature_lines, "parity_splits"_a = r.parity_splits, "inverted"_a = r.inverted,
                  "reduction_percent"_a = r.reduction_percent, "euler_in"_a = r.euler_in, "euler_out"_a = r.euler_out);
    const auto add = [&dict](const py::dict& group) { dict.attr("update")(group); };
    add(py::dict("passes"_a = to_list(r.passes), "rows"_a = to_list(r.rows)));
    add(py::dict("scaled_jacobian"_a = to_dict(r.scaled_jacobian), "aspect_ratio"_a = to_dict(r.aspect_ratio),
                 "min_angle"_a = to_dict(r.min_angle), "max_angle"_a = to_dict(r.max_angle), "skew"_a = to_dict(r.skew),
                 "warpage"_a = to_dict(r.warpage)));
    add(py::dict("sharpest_corner"_a = r.sharpest_corner, "scaled_jacobian_limit"_a = r.scaled_jacobian_limit,
                 "scaled_jacobian_min_elsewhere"_a = r.scaled_jacobian_min_elsewhere,
                 "neighbour_area_ratio_p95"_a = r.neighbour_area_ratio_p95,
                 "neighbour_area_ratio_max"_a = r.neighbour_area_ratio_max, "valence_histogram"_a = r.valence_histogram,
                 "regular_percent"_a = r.regular_percent, "hausdorff"_a = r.hausdorff,
                 "hausdorff_relative"_a = r.hausdorff_relative));
    add(py::dict("repair"_a = to_dict(r.repair), "times"_a = to_list(r.times), "warnings"_a = r.warnings));
    return dict;
}

}  // namespace anisoquad
