#include "cad/triangulate.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

#include "cad/check_triangles.h"
#include "cad/to_eigen.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

constexpr double kDeflection = 2e-4;  ///< of the diagonal; coarser ones leave too little of thin noses and small fillets

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Nodes of all faces, those that edges share made one.
class Assembly {
  public:
    explicit Assembly(const TopoDS_Shape& shape) {
        TopExp::MapShapes(shape, TopAbs_FACE, faces_);
        TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
        at_vertex_.assign(at(vertices_.Extent()), -1);
        on_edge_.resize(at(edges_.Extent()));
        parameters_.resize(at(edges_.Extent()));
    }

    Triangulation run(const std::string& name) {
        std::vector<std::int32_t> failed;
        for (int i = 1; i <= faces_.Extent(); ++i) {
            if (!add_face(i - 1)) failed.push_back(i - 1);
        }
        if (!failed.empty()) {
            throw Error(ErrorCode::face_not_meshable,
                        "No triangles can be made on " + CadShape::names("Face", failed) + " of " + name + ".",
                        ElementKind::cad_face, failed);
        }
        return finish();
    }

  private:
    bool add_face(std::int32_t index) {
        const TopoDS_Face& face = TopoDS::Face(faces_(index + 1));
        TopLoc_Location location;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
        if (mesh.IsNull() || mesh->NbTriangles() == 0) return false;
        const auto base = static_cast<std::int32_t>(points_.size());
        for (int i = 1; i <= mesh->NbNodes(); ++i) {
            points_.push_back(to_eigen(mesh->Node(i).Transformed(location.Transformation())));
            same_.push_back(base + i - 1);
        }
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) join_edge(TopoDS::Edge(e.Current()), mesh, location, base);
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            int a = 0, b = 0, c = 0;
            mesh->Triangle(i).Get(a, b, c);
            if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
            triangles_.push_back({base + a - 1, base + b - 1, base + c - 1});
            face_.push_back(index);
        }
        return true;
    }

    void join_edge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & mesh, const TopLoc_Location& location,
                   std::int32_t base) {
        // A seam has a polygon for each of its sides: that of the orientation is given.
        const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
        if (polygon.IsNull()) return;
        std::vector<std::int32_t> nodes;
        for (int i = 1; i <= polygon->NbNodes(); ++i) nodes.push_back(base + polygon->Node(i) - 1);
        TopoDS_Vertex first, last;
        TopExp::Vertices(edge, first, last);
        join_vertex(first, nodes.front());
        join_vertex(last, nodes.back());
        if (BRep_Tool::Degenerated(edge)) {
            for (const std::int32_t node : nodes) join(nodes.front(), node);
            return;
        }
        const std::size_t index = at(edges_.FindIndex(edge) - 1);
        std::vector<std::int32_t>& known = on_edge_[index];
        if (known.empty()) {
            known = nodes;
            for (int i = 1; polygon->HasParameters() && i <= polygon->NbNodes(); ++i)
                parameters_[index].push_back(polygon->Parameter(i));
        }
        for (std::size_t i = 0; i < std::min(known.size(), nodes.size()); ++i) join(known[i], nodes[i]);
    }

    void join_vertex(const TopoDS_Vertex& vertex, std::int32_t node) {
        std::int32_t& known = at_vertex_[at(vertices_.FindIndex(vertex) - 1)];
        if (known < 0) known = node;
        join(known, node);
    }

    std::int32_t root(std::int32_t i) {
        while (same_[at(i)] != i) i = same_[at(i)] = same_[at(same_[at(i)])];
        return i;
    }
    void join(std::int32_t a, std::int32_t b) {
        a = root(a);
        b = root(b);
        same_[at(std::max(a, b))] = std::min(a, b);
    }

    Triangulation finish() {
        Triangulation result;
        std::vector<std::int32_t> number(points_.size(), -1);
        const auto numbered = [&](std::int32_t node) {
            std::int32_t& n = number[at(root(node))];
            if (n < 0) {
                n = static_cast<std::int32_t>(result.points.size());
                result.points.push_back(points_[at(root(node))]);
            }
            return n;
        };
        for (std::size_t f = 0; f < triangles_.size(); ++f) {
            const auto& [a, b, c] = triangles_[f];
            if (root(a) == root(b) || root(b) == root(c) || root(c) == root(a)) continue;  // at a pole
            const std::int32_t first = numbered(a);
            const std::int32_t second = numbered(b);
            result.triangles.push_back({first, second, numbered(c)});
            result.origin.facet_face.push_back(face_[f]);
        }
        for (std::size_t e = 0; e < on_edge_.size(); ++e) {
            EdgePath path;
            if (!parameters_[e].empty()) {
                for (std::size_t i = 0; i < on_edge_[e].size(); ++i) {
                    const std::int32_t v = numbered(on_edge_[e][i]);
                    if (!path.vertices.empty() && path.vertices.back() == v) continue;
                    path.vertices.push_back(v);
                    path.parameters.push_back(parameters_[e][i]);
                }
            }
            result.origin.paths.push_back(std::move(path));
        }
        return result;
    }

    TopTools_IndexedMapOfShape faces_, edges_, vertices_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<std::int32_t> same_;
    std::vector<std::array<std::int32_t, 3>> triangles_;
    std::vector<std::int32_t> face_;  ///< per triangle
    std::vector<std::int32_t> at_vertex_;
    std::vector<std::vector<std::int32_t>> on_edge_;
    std::vector<std::vector<double>> parameters_;  ///< of the nodes on each edge
};

/// Without vertices that are in no triangle: other programs would not keep them.
void drop_unused(Triangulation& made) {
    std::vector<std::int32_t> number(made.points.size(), -1);
    for (const auto& t : made.triangles) {
        for (const std::int32_t v : t) number[at(v)] = 0;
    }
    std::int32_t count = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        made.points[at(count)] = made.points[v];
        number[v] = count++;
    }
    made.points.resize(at(count));
    for (auto& t : made.triangles) {
        for (std::int32_t& v : t) v = number[at(v)];
    }
    for (EdgePath& path : made.origin.paths) {
        for (std::int32_t& v : path.vertices) v = number[at(v)];
        if (std::ranges::find(path.vertices, -1) != path.vertices.end()) path = {};
    }
}

/// Mends the triangles, and lets their origin follow: of a line that got other vertices none is known.
void mend(Triangulation& made) {
    std::vector<std::vector<std::int32_t>> lines;
    for (const EdgePath& path : made.origin.paths) lines.push_back(path.vertices);
    const std::vector<std::int32_t> before = mend_triangles(made.points, made.triangles, lines);
    std::vector<std::int32_t> facet_face;
    for (const std::int32_t f : before) facet_face.push_back(f < 0 ? -1 : made.origin.facet_face[at(f)]);
    made.origin.facet_face = std::move(facet_face);
    for (std::size_t e = 0; e < lines.size(); ++e) {
        EdgePath& path = made.origin.paths[e];
        if (lines[e].size() != path.vertices.size())
            path = {};
        else
            path.vertices = std::move(lines[e]);
    }
    drop_unused(made);
}

}  // namespace

Triangulation triangulate(const CadShape& shape, const TriangulateOptions& options) {
    if (!(options.deflection >= 0.0) || !(options.angle > 0.0 && options.angle <= 90.0)) {
        throw Error(ErrorCode::invalid_option, "The deflection is 0 or more, the angle between 0 and 90 degrees.");
    }
    const double deflection = options.deflection > 0.0 ? options.deflection : kDeflection * shape.diagonal();
    try {
        // The mesh is kept in the shape: a copy of its topology leaves the given one, and what meshed it before, alone.
        const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape.shape(), Standard_False).Shape();
        const BRepMesh_IncrementalMesh mesh(copy, deflection, Standard_False, options.angle * std::numbers::pi / 180.0,
                                            Standard_False);
        Triangulation result = Assembly(copy).run(shape.name());
        mend(result);
        return result;
    } catch (const Standard_Failure& failure) {
        throw Error(ErrorCode::face_not_meshable, shape.name() + " can't be triangulated: " + failure.GetMessageString());
    }
}

bool is_same(const Triangulation& made, std::span<const Eigen::Vector3d> points,
             std::span<const std::array<std::int32_t, 3>> triangles, double diagonal) {
    return std::equal(made.triangles.begin(), made.triangles.end(), triangles.begin(), triangles.end()) &&
           std::equal(
               made.points.begin(), made.points.end(), points.begin(), points.end(),
               [diagonal](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() <= kRounding * diagonal; });
}

}  // namespace anisoquad::cad
