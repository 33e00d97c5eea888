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

double diagonal(const shapes::Shape& shape) {
    Eigen::AlignedBox3d box;
    for (const Point& p : shape.points) box.extend(p);
    return shape.points.empty() ? 0.0 : box.diagonal().norm();
}

/// Asks for quads of a size, or for one size per vertex, that come to some hundred quads at most.
void ask_for_size(MeshCase& result, ByteSource& source) {
    Options& options = result.options;
    const double largest = diagonal(result.shape) / source.between(1, 4);
    if (source.one_in(4)) {
        const std::array<double, 2> share{0.3 + 0.7 * source.fraction(), 0.3 + 0.7 * source.fraction()};
        const std::size_t n = result.shape.points.size();
        for (std::size_t i = 0; i < n; ++i) options.vertex_size.push_back(largest * share[2 * i / n]);
    } else {
        options.size = largest;
    }
    if (source.one_in(4)) options.growth = 1.01 + 2.0 * source.fraction();
    if (source.one_in(4)) options.curvature_angle = 180.0 * source.fraction();
}

bool passes_checks(const MeshCase& c) {
    try {
        check_options(c.options, c.shape.points.size());
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
    // What takes long is rare where executions are to be many. Options come first: what follows them may be of any length.
    const int rarely = may_be_bad ? 64 : 6;
    const double extent = source.one_in(rarely) ? 1.0 : 0.1 + 0.4 * source.fraction();
    const bool own_size = source.one_in(rarely);
    const bool size_asked = !own_size && source.one_in(3);
    options.prepare = source.one_in(3);
    options.cleanup = source.one_in(4) == may_be_bad;  // most of the time goes there
    if (source.one_in(4)) options.feature_angle = 1.0 + 179.0 * source.fraction();
    if (source.one_in(4)) options.row_growth = 1.0 + source.fraction();
    if (source.one_in(4)) options.smoothing_passes = source.below(8);
    options.repair = may_be_bad && source.one_in(2);
    const bool spoilt = may_be_bad && source.one_in(2);

    result.shape = make_surface(source, extent);
    // A size of its own choice makes a thousand quads of anything.
    if (!own_size) options.prepare = false;
    if (size_asked) ask_for_size(result, source);
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
        << c.options.repair << " size " << c.options.size << " growth " << c.options.growth << " curvature_angle "
        << c.options.curvature_angle << "\n# feature_edges";
    for (const auto& e : c.options.feature_edges) out << " " << e[0] << "-" << e[1];
    if (!c.options.vertex_size.empty()) out << "\n# vertex_size";
    for (const double size : c.options.vertex_size) out << " " << size;
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
