#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

/// The one operation of the clean-up: the quads of a disk are replaced by others with the same outline. Every pattern is
/// expressed by it, and it is its own inverse.
namespace anisoquad {

/// A disk of quads.
struct Region {
    std::vector<Face> faces;
    std::vector<HalfEdge> loop;  ///< outline, the faces on its left
    std::vector<Vertex> inner;   ///< nodes that are not on the outline
};

/// Quads in place of a region's.
struct Replacement {
    struct Node {
        Point place = Point::Zero();
        VertexInfo info;
    };
    std::vector<std::array<Vertex, 4>> quads;  ///< nodes of the outline, or new_node(k)
    std::vector<Node> nodes;                   ///< new nodes

    /// Stands for nodes[k] in `quads`.
    static constexpr Vertex new_node(std::size_t k) { return Vertex(-2 - static_cast<std::int32_t>(k)); }
    static constexpr bool is_new(Vertex v) { return v.index() <= -2; }
    static constexpr std::size_t index(Vertex v) { return static_cast<std::size_t>(-2 - v.index()); }
};

/// Marks on elements that are taken back in no time.
class Marks {
  public:
    void clear(std::int32_t slots) {
        if (stamp_.size() < static_cast<std::size_t>(slots)) stamp_.resize(static_cast<std::size_t>(slots), 0);
        ++current_;
    }
    /// @returns false if it was marked already
    template <class Tag>
    bool mark(Handle<Tag> h) {
        std::uint32_t& stamp = stamp_[static_cast<std::size_t>(h.index())];
        if (stamp == current_) return false;
        stamp = current_;
        return true;
    }
    template <class Tag>
    bool has(Handle<Tag> h) const {
        return stamp_[static_cast<std::size_t>(h.index())] == current_;
    }

  private:
    std::vector<std::uint32_t> stamp_;
    std::uint32_t current_ = 0;
};

/// Finds outlines and replaces quads; keeps the scratch memory.
class RegionEditor {
  public:
    explicit RegionEditor(SurfaceMesh& mesh) : mesh_(mesh) {}

    /// True if one of the face's nodes lies on a cut: it has other faces, which are not in this part.
    bool is_at_cut(Face f) const;
    /// Fills in the outline and the inner nodes of region.faces. @returns false unless the faces are quads outside of rows and
    /// away from cuts, and a disk with a simple outline, without fixed edges and fixed nodes inside
    bool find_outline(Region& region);
    /// The two halves of find_outline(), for what grows a region: the outline, and then the inner nodes. @pre of find_inner():
    /// trace_outline() of the same faces has just returned true
    bool trace_outline(Region& region);
    bool find_inner(Region& region);

    /// The replacement that changes nothing: what undoes another one.
    Replacement current(const Region& region) const;

    /// True if the replacement makes a proper mesh: every edge of the outline once, every edge inside once in each direction,
    /// no edge that exists outside of the region, and no two quads on the same nodes.
    bool is_possible(const Region& region, const Replacement& replacement);

    /// Does it; `region` becomes the new quads and nodes, in the order of the replacement. When a replacement is undone by
    /// what current() gave before, faces and nodes have the handles they had. @pre is_possible()
    void replace(Region& region, const Replacement& replacement);

  private:
    struct Side {  ///< of a new quad
        Vertex from;
        Vertex to;
        HalfEdge halfedge;
    };
    Vertex handle(Vertex v) const { return Replacement::is_new(v) ? new_nodes_[Replacement::index(v)] : v; }

    bool lies_on_another_face(const Replacement& replacement) const;

    SurfaceMesh& mesh_;
    Marks face_marks_;
    Marks vertex_marks_;
    std::vector<Side> sides_;
    std::vector<Vertex> new_nodes_;
};

}  // namespace anisoquad
