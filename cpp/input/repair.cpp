#include "input/repair.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "input/degenerate_facets.h"
#include "input/drop_facets.h"
#include "input/facet_mates.h"
#include "input/repaired_paths.h"
#include "input/weld_points.h"

namespace anisoquad {
namespace {

TriangleSoup make_soup(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    TriangleSoup soup;
    soup.points.assign(points.begin(), points.end());
    soup.triangles.assign(triangles.begin(), triangles.end());
    soup.origin.resize(points.size());
    std::iota(soup.origin.begin(), soup.origin.end(), 0);
    soup.merged_into = soup.origin;
    return soup;
}

/// Vertices that no facet uses are no part of the surface, wherever they are.
void place_unused_vertices(TriangleSoup& soup) {
    if (soup.triangles.empty()) return;
    std::vector<char> used(soup.points.size(), 0);
    for (const auto& t : soup.triangles) {
        for (const std::int32_t v : t) used[static_cast<std::size_t>(v)] = 1;
    }
    const Point somewhere = soup.point(soup.triangles[0][0]);
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) soup.points[v] = somewhere;
    }
}

}  // namespace

RepairResult repair_surface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                            std::span<const Source> sources, std::span<const std::array<std::int32_t, 2>> feature_edges) {
    TriangleSoup soup = make_soup(points, triangles);
    RepairReport report;
    report.out_of_range_facets = drop_out_of_range(soup);
    report.non_finite_facets = drop_non_finite(soup);
    report.degenerate_facets = drop_repeated_corners(soup);
    const std::vector<std::int32_t> place = points_at_one_place(soup);
    report.duplicate_facets = drop_doubled(soup, place);
    report.welded_vertices = weld_open_edges(soup, place);
    report.degenerate_facets += drop_repeated_corners(soup);
    report.duplicate_facets += drop_duplicates(soup);
    report.degenerate_facets += mend_degenerate_facets(soup);
    std::vector<std::int32_t> mate = pair_facets(soup, report.cut_edges);
    unify_orientation(soup, mate, report.flipped_facets, report.cut_edges);
    report.new_vertices = split_vertices(soup, mate);

    RepairResult result;
    const RepairedPaths paths(soup);
    for (const Source& source : sources) {
        result.sources.push_back(source);
        result.sources.back().vertices = paths.path(source.vertices);
    }
    result.feature_edges = paths.edges(feature_edges);
    place_unused_vertices(soup);
    result.points = std::move(soup.points);
    result.triangles = std::move(soup.triangles);
    result.origin = std::move(soup.origin);
    result.report = report;
    return result;
}

std::string summary(const RepairReport& report) {
    std::string text;
    const auto add = [&text](std::int32_t n, const char* one, const char* many, const char* what) {
        if (n == 0) return;
        if (!text.empty()) text += ", ";
        text += std::to_string(n) + " " + (n == 1 ? one : many) + " " + what;
    };
    add(report.out_of_range_facets, "facet", "facets", "without all vertices dropped");
    add(report.non_finite_facets, "facet", "facets", "without finite coordinates dropped");
    add(report.degenerate_facets, "facet", "facets", "without area removed");
    add(report.duplicate_facets, "facet", "facets", "doubled dropped");
    add(report.welded_vertices, "vertex", "vertices", "welded");
    add(report.cut_edges, "edge", "edges", "cut apart");
    add(report.flipped_facets, "facet", "facets", "turned");
    add(report.new_vertices, "vertex", "vertices", "added");
    return text;
}

}  // namespace anisoquad
