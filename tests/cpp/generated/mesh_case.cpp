#include "generated/mesh_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <sstream>

#include "errors.h"
#include "generated/surfaces.h"
#include "input/check.h"

namespace anisoquad::generated {
namespace {

/// A walk over edges that goes on as straight as it can and does not touch itself; closed where it comes back to its start.
std::vector<std::int32_t> walk(const SurfaceMesh& mesh, std::vector<char>& used, ByteSource& source) {
    std::vector<std::int32_t> path;
    Vertex v(source.below(std::min(mesh.vertex_slots(), 65536)));
    const int steps = source.between(1, 24);
    const bool along_boundary = source.one_in(3);
    const auto use = [&](Vertex w) { return used[static_cast<std::size_t>(w.index())]; };
    if (!mesh.halfedge(v).is_valid() || use(v)) return {};
    path.push_back(v.index());
    used[static_cast<std::size_t>(v.index())] = 1;
    Eigen::Vector3d direction(source.signed_fraction(), source.signed_fraction(), source.signed_fraction());
    for (int i = 0; i < steps; ++i) {
        HalfEdge best;
        double most = -std::numeric_limits<double>::infinity();
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (along_boundary && mesh.is_boundary(v) && !mesh.is_boundary(SurfaceMesh::edge(h))) continue;
            const bool closes = i >= 2 && mesh.to(h).index() == path.front();
            const double straight = direction.dot((mesh.position(mesh.to(h)) - mesh.position(v)).normalized());
            if ((use(mesh.to(h)) && !closes) || straight <= most) continue;
            most = straight;
            best = h;
        }
        if (!best.is_valid()) break;
        direction = (mesh.position(mesh.to(best)) - mesh.position(v)).normalized();
        v = mesh.to(best);
        path.push_back(v.index());
        if (use(v)) break;
        used[static_cast<std::size_t>(v.index())] = 1;
    }
    return path.size() > 1 ? path : std::vector<std::int32_t>();
}

void add_sources(MeshCase& result, const SurfaceMesh& mesh, ByteSource& source) {
    std::vector<char> used(static_cast<std::size_t>(mesh.vertex_slots()), 0);
    const int lines = source.one_in(2) ? source.below(3) : 0;
    for (int i = 0; i < lines; ++i) {
        Source line;
        line.vertices = walk(mesh, used, source);
        const int passes = source.below(4);
        for (int k = 0; k < passes; ++k) line.passes.push_back({source.between(1, 5), source.below(4)});
        line.sides = static_cast<Sides>(source.below(3));
        if (!line.vertices.empty()) result.sources.push_back(line);
    }
}

void add_feature_edges(MeshCase& result, const SurfaceMesh& mesh, ByteSource& source) {
    if (!source.one_in(3)) return;
    const int share = source.between(1, 40);
    auto state = static_cast<std::uint32_t>(source.byte());
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        state = 1664525u * state + 1013904223u;
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        if ((state >> 16) % static_cast<std::uint32_t>(share) == 0)
            result.options.feature_edges.push_back({mesh.from(h).index(), mesh.to(h).index()});
    }
}

/// Squares as small as the lowest triangle is high that would cover the surface: what remeshing comes to at worst.
double most_squares(const shapes::Shape& shape) {
    double area = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : shape.triangles) {
        const auto p = [&](std::size_t k) -> const Point& { return shape.points[static_cast<std::size_t>(t[k])]; };
        const double doubled = (p(1) - p(0)).cross(p(2) - p(0)).norm();
        least = std::min(least, doubled / std::max({(p(1) - p(0)).norm(), (p(2) - p(1)).norm(), (p(0) - p(2)).norm()}));
        area += 0.5 * doubled;
    }
    return area / (least * least);
}

bool passes_checks(const MeshCase& c) {
    try {
        check_options(c.options);
        check_input(c.shape.points, c.shape.triangles);
        const SurfaceMesh mesh = c.shape.mesh();
        check_sources(mesh, c.sources);
        check_feature_edges(mesh, c.options.feature_edges);
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

MeshCase make_case(ByteSource& source, bool may_be_bad) {
    MeshCase result;
    Options& options = result.options;
    options.validate = true;
    // Options first: what follows them may be of any length.
    options.prepare = source.one_in(3);
    options.cleanup = !source.one_in(4);
    if (source.one_in(4)) options.feature_angle = 1.0 + 179.0 * source.fraction();
    if (source.one_in(4)) options.row_growth = 1.0 + source.fraction();
    if (source.one_in(4)) options.smoothing_passes = source.below(8);
    options.repair = may_be_bad && source.one_in(2);
    const bool spoilt = may_be_bad && source.one_in(2);

    result.shape = make_surface(source);
    // A long thin strip is remeshed to squares of its width: right, but no test of some hundred triangles any more.
    if (options.prepare && most_squares(result.shape) > 300.0) options.prepare = false;
    if (!result.shape.triangles.empty()) {
        const SurfaceMesh mesh = result.shape.mesh();
        add_sources(result, mesh, source);
        add_feature_edges(result, mesh, source);
    }
    if (spoilt) {
        spoil(result.shape, source);
        if (!result.sources.empty() && source.one_in(4)) result.sources[0].vertices.push_back(source.below(512) - 8);
        if (source.one_in(16)) options.feature_edges.push_back({source.below(64) - 1, source.below(64)});
        if (source.one_in(16)) options.feature_angle = 200.0 * source.signed_fraction();
    }
    result.is_valid = passes_checks(result);
    return result;
}

std::string to_text(const MeshCase& c) {
    std::ostringstream out;
    out.precision(17);
    out << "OFF\n" << c.shape.points.size() << " " << c.shape.triangles.size() << " 0\n";
    for (const Point& p : c.shape.points) out << p.x() << " " << p.y() << " " << p.z() << "\n";
    for (const auto& t : c.shape.triangles) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    out << "# prepare " << c.options.prepare << " cleanup " << c.options.cleanup << " feature_angle " << c.options.feature_angle
        << " row_growth " << c.options.row_growth << " smoothing_passes " << c.options.smoothing_passes << " repair "
        << c.options.repair << "\n# feature_edges";
    for (const auto& e : c.options.feature_edges) out << " " << e[0] << "-" << e[1];
    for (const Source& s : c.sources) {
        out << "\n# source sides " << static_cast<int>(s.sides) << " passes";
        for (const Pass& p : s.passes) out << " " << p.ratio << ":" << p.rows;
        out << " vertices";
        for (const std::int32_t v : s.vertices) out << " " << v;
    }
    out << "\n";
    return out.str();
}

}  // namespace anisoquad::generated
