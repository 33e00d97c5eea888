#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "surface/facet_tree.h"
#include "surface/target_surface.h"

namespace anisoquad {

/// Closest point of a surface.
struct SurfacePoint {
    Point position = Point::Zero();
    std::int32_t facet = -1;  ///< -1: no facet (empty surface, or no facet of the wanted patch)
    double distance = 0.0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, interpolated from the corners' normals inside the patch
};

/// What of a surface is meant: one patch, of which two sheets can lie close together (the skin of a wing near its trailing edge).
struct Sheet {
    std::int32_t patch;
    Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< direction that the sheet faces, of any length; zero: either sheet

    // NOLINTNEXTLINE(google-explicit-constructor): a patch is a sheet that faces anywhere
    Sheet(std::int32_t of_patch) : patch(of_patch) {}
    Sheet(std::int32_t of_patch, const Eigen::Vector3d& facing) : patch(of_patch), up(facing) {}
};

/// The input triangulation, kept unchanged: what nodes are brought back to after they were moved.
///
/// Closest points are those of a FacetTree. Queries are const and may run in parallel.
class ReferenceSurface {
  public:
    static constexpr std::int32_t kAnyPatch = FacetTree::kAnyPatch;

    ReferenceSurface() = default;
    /// @param facet_patch patch of each facet; empty: all are patch 0
    /// @param crease_angle degrees; a corner's normal is the mean over the facets that are reached from its facet round the
    ///        vertex without crossing an edge between patches or one where the facets turn by more than this
    /// @throws Error{cancelled}
    ReferenceSurface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                     std::span<const std::int32_t> facet_patch = {}, double crease_angle = 40.0,
                     const Context& context = no_context());

    /// Where the closest facet faces away from the sheet's direction, and one that does not is near, the latter's point.
    SurfacePoint closest(const Point& p, const Sheet& sheet = kAnyPatch) const;
    /// The same, faster when `hint` is a facet near p (-1: none), see FacetTree::closest().
    SurfacePoint closest(const Point& p, const Sheet& sheet, std::int32_t hint) const;

    /// Distance of p from its patch, exact where it is above `enough`: a walk from the hint that comes nearer than that does.
    /// @param hint in: facet near p or -1, out: facet of the point that was found
    double distance(const Point& p, std::int32_t patch, double enough, std::int32_t& hint) const;

    /// Closest point, lifted off its facet by the quadratic that has the corners' normals, so that a curved surface is not
    /// flattened onto its facets (α = 1/2 of @cite boubekeur2008phong is exact for quadrics). The lift is zero on flat facets
    /// and never more than a tenth of the facet's height or 5e-4 of the surface's diagonal.
    /// With a target (set_target()) the target's point instead.
    /// @param hint in: facet near p or -1, out: facet of the closest point
    Point project(const Point& p, const Sheet& sheet, std::int32_t& hint) const;
    /// Where p is on the facets of its patch. @param hint as in project()
    TargetPlace place(const Point& p, std::int32_t patch, std::int32_t& hint) const;

    /// From now on project() asks the surface of which these facets are a triangulation. @param target outlives this
    void set_target(const FramedTarget& target) { target_ = target; }
    const FramedTarget& target() const { return target_; }

    const FacetTree& tree() const { return tree_; }
    std::int32_t facet_count() const { return tree_.count(); }
    std::int32_t facet_patch(std::int32_t facet) const { return tree_.patch(facet); }
    const Eigen::Vector3d& facet_normal(std::int32_t facet) const { return facet_normal_[static_cast<std::size_t>(facet)]; }
    /// Diagonal of the bounding box.
    double diagonal() const { return tree_.diagonal(); }

  private:
    void compute_normals(double crease_angle, const Context& context);
    FacetTree::Hit hit(const Point& p, const Sheet& sheet, std::int32_t hint) const;
    Eigen::Vector3d interpolated_normal(const FacetTree::Hit& c) const;

    FacetTree tree_;
    std::vector<Eigen::Vector3d> facet_normal_;
    std::vector<std::array<Eigen::Vector3f, 3>> corner_normal_;
    std::vector<float> lift_limit_;  ///< per facet: of the way that project() lifts a point off it
    FramedTarget target_;
};

}  // namespace anisoquad
