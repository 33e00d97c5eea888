#include "cad/smooth_edges.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <cmath>
#include <numbers>

#include "cad/closest_point.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 8;  ///< along the edge, at the middles of as many parts

/// Normal of a face at a parameter of its edge; zero where it has none.
Vector3d normal_at(const CadFace& face, const Handle(Geom2d_Curve) & curve, double t) {
    const gp_Pnt2d x = curve->Value(t);
    return face_normal(face, {x.X(), x.Y()});
}

bool is_smooth(const CadShape& shape, const CadEdge& edge, double cosine) {
    if (!edge.is_border() || edge.faces.size() != 2) return false;
    const CadFace& one = shape.face(edge.faces[0]);
    const CadFace& other = shape.face(edge.faces[1]);
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom2d_Curve) on_one = BRep_Tool::CurveOnSurface(edge.edge, one.face, first, last);
    const Handle(Geom2d_Curve) on_other = BRep_Tool::CurveOnSurface(edge.edge, other.face, first, last);
    if (on_one.IsNull() || on_other.IsNull()) return false;
    for (int i = 0; i < kSamples; ++i) {
        const double t = first + (last - first) * (i + 0.5) / kSamples;
        const Vector3d a = normal_at(one, on_one, t);
        const Vector3d b = normal_at(other, on_other, t);
        if (!a.isZero() && !b.isZero() && a.dot(b) < cosine) return false;
    }
    return true;
}

}  // namespace

std::vector<char> smooth_edges(const CadShape& shape, double angle) {
    const double cosine = std::cos(angle * std::numbers::pi / 180.0);
    std::vector<char> smooth;
    for (const CadEdge& edge : shape.edges()) smooth.push_back(is_smooth(shape, edge, cosine) ? 1 : 0);
    return smooth;
}

}  // namespace anisoquad::cad
