#pragma once

#include <Eigen/Core>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// OpenCASCADE behind the mesh: the exact shape of which the input's triangles are a triangulation.
namespace anisoquad::cad {

inline constexpr double kRounding = 1e-6;  ///< of a shape's diagonal: meshes may hold single precision

/// One end of the range of a parameter, and whether the surface or curve comes round to its begin there.
struct Range {
    double low = 0.0;
    double high = 0.0;
    bool closed = false;    ///< both ends are the same place
    bool periodic = false;  ///< closed, and parameters beyond the ends are taken round
};

struct FaceSamples;

struct CadFace {
    TopoDS_Face face;
    Handle(Geom_Surface) surface;          ///< in the shape's coordinates, its location applied
    std::array<Range, 2> range;            ///< of u and v, those of the face
    bool reversed = false;                 ///< the face's normal is against that of the surface
    std::vector<std::int32_t> edges;       ///< ascending, each once
    std::shared_ptr<FaceSamples> samples;  ///< see samples_of()
};

struct CadEdge {
    TopoDS_Edge edge;
    Handle(Geom_Curve) curve;              ///< null where the edge is degenerated (a pole); its location applied
    Range range;                           ///< of the parameter
    std::array<std::int32_t, 2> vertex{};  ///< at the low and the high end of the range
    std::vector<std::int32_t> faces;       ///< beside it, each once
    bool seam = false;                     ///< joins a face with itself; others may end there too
    double length = 0.0;                   ///< in the shape's unit

    bool is_degenerated() const { return curve.IsNull(); }
    /// True where patches of faces end: everything but poles, and seams on which no other face ends.
    bool is_border() const { return !is_degenerated() && !(seam && faces.size() == 1); }
};

/// A shape with its faces, edges and vertices numbered from 0 in the order of FreeCAD's names: Face1 is face 0.
/// Queries are const, and safe from several threads.
class CadShape {
  public:
    /// @param name for messages
    /// @throws Error{invalid_shape} if the shape is null or has no faces
    explicit CadShape(TopoDS_Shape shape, std::string name = "The shape");

    const TopoDS_Shape& shape() const { return shape_; }
    const std::string& name() const { return name_; }
    std::span<const CadFace> faces() const { return faces_; }
    std::span<const CadEdge> edges() const { return edges_; }
    std::span<const Eigen::Vector3d> vertices() const { return vertices_; }
    const CadFace& face(std::int32_t i) const { return faces_[static_cast<std::size_t>(i)]; }
    const CadEdge& edge(std::int32_t i) const { return edges_[static_cast<std::size_t>(i)]; }
    const Eigen::Vector3d& vertex(std::int32_t i) const { return vertices_[static_cast<std::size_t>(i)]; }
    /// Diagonal of the bounding box.
    double diagonal() const { return diagonal_; }

    /// "Face3, Face7, …" of face ids, or the same for "Edge".
    static std::string names(const char* kind, std::span<const std::int32_t> ids);

  private:
    TopoDS_Shape shape_;
    std::string name_;
    std::vector<CadFace> faces_;
    std::vector<CadEdge> edges_;
    std::vector<Eigen::Vector3d> vertices_;
    double diagonal_ = 0.0;
};

/// Faces in which OpenCASCADE finds errors.
std::vector<std::int32_t> invalid_faces(const CadShape& shape);
/// @throws Error{invalid_shape} that names the shape's invalid faces, if it has any
void check_shape(const CadShape& shape);

}  // namespace anisoquad::cad
