#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cad/link_mesh.h"
#include "cad/path_edges.h"
#include "cad/shape.h"
#include "surface/target_surface.h"

namespace anisoquad::cad {

/// The shape behind a linked triangulation, as the mesher's target: nodes of lines on CAD edges go onto the edge's curve, all
/// others onto the face of the facet near them, searched from the parameters of the facet's corners. Where patches run over edges
/// between faces (smooth ones that were joined), a node whose point is outside of its face goes on to the face beyond, or to the
/// edge.
class CadSurface : public TargetSurface {
  public:
    /// @param triangles those that were linked; @param joined per CAD edge: 1 where patches run over it
    CadSurface(std::shared_ptr<const CadShape> shape, std::shared_ptr<const MeshLink> link, Triangles triangles,
               std::span<const char> joined = {});
    ~CadSurface() override;

    void project(std::span<const TargetPlace> places, std::span<Eigen::Vector3d> points) const override;
    /// CAD edge on which a mesh edge of the input lies, -1 = none.
    std::int32_t edge_of(std::int32_t a, std::int32_t b) const { return on_path_.find(a, b).edge; }
    /// The mesh edges that are borders of patches: on CAD edges between faces, those that were joined left out.
    std::vector<std::array<std::int32_t, 2>> feature_edges() const;
    const CadShape& shape() const { return *shape_; }
    const MeshLink& link() const { return *link_; }

  private:
    struct Beyond;
    struct Trims;

    void find_beyond();
    Eigen::Vector3d on_face(const TargetPlace& place, const Eigen::Vector3d& p) const;
    Eigen::Vector3d over_joints(std::int32_t facet, const Eigen::Vector3d& p, const Eigen::Vector3d& found,
                                const Eigen::Vector2d& parameter) const;

    std::shared_ptr<const CadShape> shape_;
    std::shared_ptr<const MeshLink> link_;
    std::vector<std::array<std::int32_t, 3>> triangles_;
    PathEdges on_path_;
    std::unique_ptr<const Trims> trims_;
    std::vector<char> joined_;
    std::vector<std::int32_t> first_beyond_;  ///< per facet, into beyond_
    std::vector<Beyond> beyond_;
};

}  // namespace anisoquad::cad
