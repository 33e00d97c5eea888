#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// What the stages work on instead of the user's arrays: vertices and triangles in spatial order, the model at the origin and of
/// diagonal 1, so that nothing depends on where it stands, how large it is and in which order it was given.
class WorkingInput {
  public:
    using Triangles = std::span<const std::array<std::int32_t, 3>>;

    /// @param points, triangles of the user, which must outlive this; @pre check_input() has passed
    /// @param keep_order for what knows triangles by their ids
    WorkingInput(std::span<const Point> points, Triangles triangles, bool keep_order, const Context& context);

    const std::vector<Point>& points() const { return unit_points_; }
    Triangles triangles() const { return triangles_; }
    /// Place of each of the user's vertices; empty where the order was kept.
    std::span<const std::int32_t> rank() const { return rank_; }
    /// In the user's unit: the place of the origin here, and the length of what has length 1 here.
    const Point& centre() const { return centre_; }
    double scale() const { return scale_; }

    /// Vertex ids that the user gave become places, once; rank() is empty afterwards.
    void put_in_order(std::vector<Source>& sources, Options& options);

    /// Collapses needles (input/needles.h) of the mesh, and takes the triangles that vanish out of both, so that the mesh is
    /// fresh from from_arrays(points(), triangles()) again.
    /// @param mesh, @pre as for turn_slivers_of()
    /// @returns the number of edges that were collapsed
    int collapse_needles_of(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options, const Context& context);

    /// Turns slivers (input/slivers.h) of the mesh, and of the triangles with them.
    /// @param mesh fresh from from_arrays(points(), triangles()) @pre put_in_order(sources, options); the order was not kept
    /// @returns the number of triangles that changed
    std::size_t turn_slivers_of(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options);

    /// The user's vertex at a place, -1 for -1.
    std::int32_t input_vertex(std::int32_t place) const { return place < 0 || vertex_.empty() ? place : vertex_[at(place)]; }
    /// Where a node stands in the user's unit: exactly at the input vertex that it is.
    Point place_of(const SurfaceMesh& mesh, Vertex v) const;

    /// Gives back the memory of points and triangles, which no later stage asks for.
    void release_arrays();

  private:
    static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
    void put_triangles_in_order();

    std::span<const Point> points_;  ///< as the user gave them
    Triangles triangles_;
    Point centre_ = Point::Zero();
    double scale_ = 1.0;
    std::vector<std::int32_t> vertex_;  ///< the user's vertex at each place; empty where the order was kept
    std::vector<std::int32_t> rank_;
    std::vector<std::array<std::int32_t, 3>> ordered_triangles_;
    std::vector<Point> unit_points_;
};

}  // namespace anisoquad
