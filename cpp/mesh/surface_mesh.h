#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cstdint>
#include <vector>

#include "mesh/handles.h"

namespace anisoquad {

using Point = Eigen::Vector3d;

/// How a node may move.
enum class NodeKind : std::uint8_t {
    interior,  ///< anywhere on the surface
    line,      ///< along its feature line only
    corner,    ///< not at all: end, junction or sharp turn of feature lines
};

struct VertexInfo {
    std::int32_t input = -1;  ///< input vertex at whose place the node still is, -1 for a new or moved node
    std::int32_t line = -1;   ///< feature line the node lies on (corners: one of them), -1 = none
    double size = 0.0;        ///< wanted edge length of quads here (see qmorph/node_size.h), 0 = not known
    NodeKind kind = NodeKind::interior;
    bool in_row = false;  ///< node of an anisotropic row: moved only by what keeps the rows' shape
};

struct EdgeInfo {
    std::int32_t line = -1;  ///< feature line that the edge covers, -1 = none
    bool source = false;     ///< edge of a source of anisotropy
    bool cut = false;        ///< inside the mesh, but on the boundary of the part that is worked on (parts/division.h)
};

struct FaceInfo {
    std::int32_t patch = -1;
    std::int32_t row = 0;   ///< 1-based from the source, 0 = not in a row
    std::int32_t pass = 0;  ///< 1-based
    std::int32_t source = -1;
};

/// Mixed triangle/quad half-edge mesh that carries the whole flow of data.
///
/// One 16-byte record per half-edge in one array; the two halves of an edge are neighbours there, so twin(h) = h ^ 1 and
/// edge(h) = h >> 1. Half-edges without a face lie on the boundary and are linked into loops like those of a face. The
/// outgoing half-edge of a boundary vertex is the one without a face. Deleted slots are reused: a queued handle can name
/// another element later. Deleted elements are skipped with is_deleted() when iterating over indices.
class SurfaceMesh {
  public:
    // --- sizes of the arrays, deleted slots included
    std::int32_t vertex_slots() const { return static_cast<std::int32_t>(points_.size()); }
    std::int32_t halfedge_slots() const { return static_cast<std::int32_t>(halfedges_.size()); }
    std::int32_t edge_slots() const { return halfedge_slots() / 2; }
    std::int32_t face_slots() const { return static_cast<std::int32_t>(face_halfedge_.size()); }

    std::int32_t vertex_count() const { return vertex_slots() - static_cast<std::int32_t>(free_vertices_.size()); }
    std::int32_t edge_count() const { return edge_slots() - static_cast<std::int32_t>(free_edges_.size()); }
    std::int32_t face_count() const { return face_slots() - static_cast<std::int32_t>(free_faces_.size()); }

    bool is_deleted(Vertex v) const { return vertex_halfedge_[at(v)] == HalfEdge(kDeleted); }
    bool is_deleted(HalfEdge h) const { return halfedges_[at(h)].from == Vertex(kDeleted); }
    bool is_deleted(Edge e) const { return is_deleted(halfedge(e)); }
    bool is_deleted(Face f) const { return face_halfedge_[at(f)] == HalfEdge(kDeleted); }

    // --- connectivity
    static HalfEdge twin(HalfEdge h) { return HalfEdge(h.index() ^ 1); }
    static Edge edge(HalfEdge h) { return Edge(h.index() >> 1); }
    static HalfEdge halfedge(Edge e, int side = 0) { return HalfEdge(2 * e.index() + side); }
    HalfEdge next(HalfEdge h) const { return halfedges_[at(h)].next; }
    HalfEdge prev(HalfEdge h) const { return halfedges_[at(h)].prev; }
    Vertex from(HalfEdge h) const { return halfedges_[at(h)].from; }
    Vertex to(HalfEdge h) const { return halfedges_[at(twin(h))].from; }
    Face face(HalfEdge h) const { return halfedges_[at(h)].face; }
    /// Outgoing half-edge; the one without a face at a boundary vertex; invalid at an isolated vertex.
    HalfEdge halfedge(Vertex v) const { return vertex_halfedge_[at(v)]; }
    HalfEdge halfedge(Face f) const { return face_halfedge_[at(f)]; }
    /// Next outgoing half-edge around from(h), counter-clockwise (seen with the surface normal up).
    HalfEdge rotated_ccw(HalfEdge h) const { return twin(prev(h)); }
    /// Next outgoing half-edge around from(h), clockwise.
    HalfEdge rotated_cw(HalfEdge h) const { return next(twin(h)); }

    bool is_boundary(HalfEdge h) const { return !face(h).is_valid(); }
    bool is_boundary(Edge e) const { return is_boundary(halfedge(e, 0)) || is_boundary(halfedge(e, 1)); }
    bool is_boundary(Vertex v) const { return !halfedge(v).is_valid() || is_boundary(halfedge(v)); }
    bool is_triangle(Face f) const {
        const HalfEdge h = halfedge(f);
        return prev(h) == next(next(h));
    }
    bool is_quad(Face f) const {
        const HalfEdge h = halfedge(f);
        return prev(h) == next(next(next(h)));
    }
    /// Number of edges at the vertex.
    int valence(Vertex v) const;
    /// Number of edges of the face.
    int valence(Face f) const;
    /// Half-edge from `a` to `b`, invalid if no edge joins them.
    HalfEdge find_halfedge(Vertex a, Vertex b) const;
    /// True if a face holds all four nodes, in whatever order: a quad on them would be its copy.
    bool has_face_on(Vertex a, Vertex b, Vertex c, Vertex d) const;

    // --- geometry and attributes
    const Point& position(Vertex v) const { return points_[at(v)]; }
    Point& position(Vertex v) { return points_[at(v)]; }
    double length(HalfEdge h) const { return (position(to(h)) - position(from(h))).norm(); }
    double length(Edge e) const { return length(halfedge(e)); }
    const VertexInfo& info(Vertex v) const { return vertex_info_[at(v)]; }
    VertexInfo& info(Vertex v) { return vertex_info_[at(v)]; }
    const EdgeInfo& info(Edge e) const { return edge_info_[at(e)]; }
    EdgeInfo& info(Edge e) { return edge_info_[at(e)]; }
    const FaceInfo& info(Face f) const { return face_info_[at(f)]; }
    FaceInfo& info(Face f) { return face_info_[at(f)]; }
    /// Boundary edges and edges on feature lines (sources among them): never flipped or removed.
    bool is_constrained(Edge e) const { return info(e).line >= 0 || is_boundary(e); }

    // --- ranges: for (HalfEdge h : mesh.outgoing(v)) …
    template <HalfEdge (SurfaceMesh::*Step)(HalfEdge) const>
    class Circulator;
    template <HalfEdge (SurfaceMesh::*Step)(HalfEdge) const>
    class Range;
    /// Outgoing half-edges of the vertex, clockwise; the mesh must not change in between.
    Range<&SurfaceMesh::rotated_cw> outgoing(Vertex v) const;
    /// Half-edges of the face in order.
    Range<&SurfaceMesh::next> halfedges(Face f) const;

    // --- building blocks of the Euler operators (mesh/euler_operators.h); not for algorithms
    Vertex add_vertex(const Point& p);
    /// New edge, linked to nothing. @returns its half-edge that leaves `a`
    HalfEdge add_edge(Vertex a, Vertex b);
    Face add_face();
    void link(HalfEdge h, HalfEdge successor) {
        halfedges_[at(h)].next = successor;
        halfedges_[at(successor)].prev = h;
    }
    void set_from(HalfEdge h, Vertex v) { halfedges_[at(h)].from = v; }
    void set_face(HalfEdge h, Face f) { halfedges_[at(h)].face = f; }
    void set_halfedge(Vertex v, HalfEdge h) { vertex_halfedge_[at(v)] = h; }
    void set_halfedge(Face f, HalfEdge h) { face_halfedge_[at(f)] = h; }
    /// Makes the outgoing half-edge of a boundary vertex the one without a face.
    void adjust_outgoing(Vertex v);
    /// Links the half-edges without a face into loops. @pre no more than one of them leaves each vertex
    void link_boundary();
    void remove(Vertex v);
    void remove(Edge e);
    void remove(Face f);
    void reserve(std::int32_t vertices, std::int32_t edges, std::int32_t faces);

  private:
    static constexpr std::int32_t kDeleted = -2;
    struct Record {
        Vertex from;
        HalfEdge next;
        HalfEdge prev;
        Face face;
    };
    static_assert(sizeof(Record) == 16);

    template <class Tag>
    static std::size_t at(Handle<Tag> handle) {
        assert(handle.index() >= 0);
        return static_cast<std::size_t>(handle.index());
    }

    std::vector<Record> halfedges_;
    std::vector<Point> points_;
    std::vector<HalfEdge> vertex_halfedge_;
    std::vector<HalfEdge> face_halfedge_;
    std::vector<VertexInfo> vertex_info_;
    std::vector<EdgeInfo> edge_info_;
    std::vector<FaceInfo> face_info_;
    std::vector<Vertex> free_vertices_;
    std::vector<Edge> free_edges_;
    std::vector<Face> free_faces_;
};

/// Forward iterator over a cycle of half-edges. The step is known to the compiler, which makes a plain loop of it.
template <HalfEdge (SurfaceMesh::*Step)(HalfEdge) const>
class SurfaceMesh::Circulator {
  public:
    Circulator(const SurfaceMesh& mesh, HalfEdge h, bool begin) : mesh_(&mesh), h_(h), begin_(begin) {}
    HalfEdge operator*() const { return h_; }
    Circulator& operator++() {
        h_ = (mesh_->*Step)(h_);
        begin_ = false;
        return *this;
    }
    bool operator!=(const Circulator& other) const { return begin_ != other.begin_ || h_ != other.h_; }

  private:
    const SurfaceMesh* mesh_;
    HalfEdge h_;
    bool begin_;
};

template <HalfEdge (SurfaceMesh::*Step)(HalfEdge) const>
class SurfaceMesh::Range {
  public:
    Range(const SurfaceMesh& mesh, HalfEdge h) : mesh_(&mesh), h_(h) {}
    Circulator<Step> begin() const { return {*mesh_, h_, h_.is_valid()}; }
    Circulator<Step> end() const { return {*mesh_, h_, false}; }

  private:
    const SurfaceMesh* mesh_;
    HalfEdge h_;
};

inline SurfaceMesh::Range<&SurfaceMesh::rotated_cw> SurfaceMesh::outgoing(Vertex v) const { return {*this, halfedge(v)}; }
inline SurfaceMesh::Range<&SurfaceMesh::next> SurfaceMesh::halfedges(Face f) const { return {*this, halfedge(f)}; }

}  // namespace anisoquad
