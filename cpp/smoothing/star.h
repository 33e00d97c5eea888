#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <optional>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// The faces round one node, copied into flat arrays: what a smoother evaluates for many trial places of the node without
/// walking over the mesh.
class Star {
  public:
    static constexpr int kCapacity = 32;
    static constexpr double kPoor = 0.6;  ///< scaled Jacobian below which an element is poor
    static constexpr double kStretchWeight = 0.05;
    static constexpr double kPlane = 0.985;  ///< least cosine between a face and the normal of a flat star

    /// @returns false if the node has no face or more than kCapacity of them
    bool gather(const SurfaceMesh& mesh, Vertex v);

    /// The node's place when the star was gathered.
    const Point& centre() const { return centre_; }
    /// Unit sum of the faces' area vectors, see node_normal().
    const Eigen::Vector3d& normal() const { return normal_; }
    /// Mean length of the node's edges.
    double edge_length() const { return edge_length_; }
    std::int32_t patch() const { return patch_; }

    /// Side from which the faces are seen: normal() unless set.
    void see_along(const Eigen::Vector3d& normal);
    /// Where the surface turns strongly round the node, one normal can't tell which faces are turned over: every face is then
    /// seen along the reference surface's normal at its middle. Elsewhere nothing changes.
    /// @param hint facet near the node, from which closest points are looked for here and in stays_near(); −1 = none
    void see_along_surface(const ReferenceSurface& reference, std::int32_t hint = -1);
    /// True where the surface hardly turns round the node: its tangent plane will do for a step.
    bool is_flat() const { return least_cosine_ >= kPlane; }
    /// True where the surface is folded round the node, and the node can only slide along the fold, if at all: off it the mesh
    /// would draw back from the fold, which no distance of the mesh from the surface tells. Known after see_along_surface().
    bool is_on_fold() const { return is_on_fold_; }
    /// With the node at p, the middles of the faces and of the node's edges don't leave the surface by more than they did or is
    /// small. Always true where the surface is hardly curved.
    bool stays_near(const ReferenceSurface& reference, const Point& p);
    /// The step without its part across the fold.
    Eigen::Vector3d along_fold(const Eigen::Vector3d& step) const { return step.dot(fold_axis_) * fold_axis_; }

    /// Every face is seen from the side that it shows now (round a node on a sharp line).
    void use_face_normals();

    struct Quality {
        double worst = 1.0;           ///< of the faces' qualities (measures: see worst_quality())
        double worst_changing = 1.0;  ///< the same without the quads' corners opposite the node, which no place of it opens
        double mean = 1.0;
        double sines = 1.0;    ///< mean of the sines of all corners of the quads
        double lack = 0.0;     ///< mean square of what the faces lack of kPoor
        double stretch = 0.0;  ///< mean square of 2 (r − 1) / (r + 1) ≈ ln r of the quads, r = longest over shortest edge
        double ratio = 1.0;    ///< largest of longest over shortest edge of the quads

        /// What a place of the node is worth in the final smoothing: the corners' mean sine, less what poor elements lack, less a
        /// little for stretched ones, since the scaled Jacobian alone lets an edge shrink to nothing.
        double score() const { return sines - lack - kStretchWeight * stretch; }
        /// ≈ ln r of a quad's ratio r.
        static double stretch_of(double r) { return 2.0 * (r - 1.0) / (r + 1.0); }
        /// Of so many faces. @param measure callable, i → FaceQuality of the i-th face
        template <class Measure>
        static Quality of_faces(int faces, const Measure& measure);
    };
    struct FaceQuality {
        double quality = -1.0;
        double changing = -1.0;  ///< without the corner opposite the node; the quality of a triangle
        double sines = -1.0;     ///< mean of the corners; the quality of a triangle
        double ratio = 1.0;      ///< longest over shortest edge; 1 for a triangle
    };
    /// Of a triangle, 1 for all that are not far from equilateral. @param area twice its area; @param squares sum of its edges'
    static double triangle_shape(double area, double squares) {
        return std::min(1.0, 6.0 * std::numbers::sqrt3 * area / squares);
    }
    /// Quality of the faces with the node at p.
    Quality quality(const Point& p) const;
    /// Quads with a corner that is turned against the quad's own normal, with the node at p: not convex, whatever the side seen
    /// from.
    int crossed(const Point& p) const;
    /// How much the star is folded: sum over the corners next to the node of the squares of what their signed area lacks of a
    /// tenth of the squared mean edge length. 0 = not at all. Convex in a plane, since those areas are linear in p: its
    /// smallest value untangles the star if anything does.
    double tangle(const Point& p) const;

  private:
    struct Wedge {
        Point next;      ///< node after the centre
        Point opposite;  ///< quads only
        Point previous;
        Eigen::Vector3d up;
        bool quad;
        // What a move of the centre leaves as it is, quads only.
        Eigen::Vector3d after_next;       ///< edge from next to opposite
        Eigen::Vector3d before_previous;  ///< edge from opposite to previous
        Eigen::Vector3d across;           ///< diagonal from next to previous
        Eigen::Vector3d opposite_area;    ///< cross product of the two edges
        double after_next_length;
        double before_previous_length;
    };
    Eigen::Vector3d area_vector(const Wedge& wedge) const;
    Point middle(const Wedge& wedge, const Point& p) const;
    /// Visits the distances of the faces' and the edges' middles from the surface, with the node at p, as long as visit(distance)
    /// returns true. They are exact where they are above `enough`. @returns whether all were visited
    template <class Visit>
    bool for_middles(const ReferenceSurface& reference, const Point& p, double enough, const Visit& visit) const;
    /// No middle is farther than `most` from the surface.
    bool is_within(const ReferenceSurface& reference, const Point& p, double most) const;
    void find_fold();
    FaceQuality quality(const Wedge& wedge, const Point& p) const;

    std::array<Wedge, kCapacity> wedges_;
    int size_ = 0;
    Point centre_ = Point::Zero();
    Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
    double edge_length_ = 0.0;
    std::int32_t patch_ = -1;
    std::int32_t hint_ = -1;  ///< facet near the node
    double upright_ = 0.0;    ///< least cosine between a face and the side that it is seen from
    bool is_on_fold_ = false;
    std::optional<double> distance_before_;                ///< with the node where it was, once it was asked for
    Eigen::Vector3d fold_axis_ = Eigen::Vector3d::Zero();  ///< zero at a tip
    double least_cosine_ = 1.0;                            ///< between a face and normal()
};

template <class Measure>
Star::Quality Star::Quality::of_faces(int faces, const Measure& measure) {
    Quality result{1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    for (int i = 0; i < faces; ++i) {
        const FaceQuality face = measure(i);
        const double lack = std::max(0.0, kPoor - face.quality);
        const double stretch = stretch_of(face.ratio);
        result.worst = std::min(result.worst, face.quality);
        result.worst_changing = std::min(result.worst_changing, face.changing);
        result.mean += face.quality;
        result.sines += face.sines;
        result.lack += lack * lack;
        result.stretch += stretch * stretch;
        result.ratio = std::max(result.ratio, face.ratio);
    }
    result.mean /= faces;
    result.sines /= faces;
    result.lack /= faces;
    result.stretch /= faces;
    return result;
}

}  // namespace anisoquad
