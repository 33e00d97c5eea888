#include "cad/shape.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>

#include "cad/face_samples.h"
#include "cad/to_eigen.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

constexpr std::size_t kMostNames = 10;

CadFace read_face(const TopoDS_Face& face) {
    CadFace f;
    f.face = face;
    f.surface = BRep_Tool::Surface(face);
    f.samples = std::make_shared<FaceSamples>();
    f.reversed = face.Orientation() == TopAbs_REVERSED;
    if (f.surface.IsNull()) return f;
    BRepTools::UVBounds(face, f.range[0].low, f.range[0].high, f.range[1].low, f.range[1].high);
    double low[2], high[2];
    f.surface->Bounds(low[0], high[0], low[1], high[1]);
    const bool closed[2] = {f.surface->IsUClosed() == Standard_True, f.surface->IsVClosed() == Standard_True};
    const bool periodic[2] = {f.surface->IsUPeriodic() == Standard_True, f.surface->IsVPeriodic() == Standard_True};
    for (std::size_t k = 0; k < 2; ++k) {
        Range& r = f.range[k];
        // The face's bounds come from its edges' curves; those of a surface with ends are never left.
        if (!periodic[k]) {
            r.low = std::max(r.low, low[k]);
            r.high = std::min(r.high, high[k]);
        }
        const double whole = high[k] - low[k];
        r.closed = closed[k] && r.high - r.low > whole * (1.0 - 1e-9);
        r.periodic = r.closed && periodic[k];
    }
    return f;
}

}  // namespace

CadShape::CadShape(TopoDS_Shape shape, std::string name) : shape_(std::move(shape)), name_(std::move(name)) {
    if (shape_.IsNull()) throw Error(ErrorCode::invalid_shape, name_ + " is empty.");
    TopTools_IndexedMapOfShape faces, edges, vertices;
    TopExp::MapShapes(shape_, TopAbs_FACE, faces);
    TopExp::MapShapes(shape_, TopAbs_EDGE, edges);
    TopExp::MapShapes(shape_, TopAbs_VERTEX, vertices);
    if (faces.IsEmpty()) throw Error(ErrorCode::invalid_shape, name_ + " has no faces.");

    for (int i = 1; i <= vertices.Extent(); ++i) vertices_.push_back(to_eigen(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)))));
    for (int i = 1; i <= edges.Extent(); ++i) {
        CadEdge e;
        e.edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
        if (!BRep_Tool::Degenerated(e.edge)) e.curve = BRep_Tool::Curve(e.edge, e.range.low, e.range.high);
        TopoDS_Vertex first, last;
        TopExp::Vertices(e.edge, first, last);
        e.vertex = {vertices.FindIndex(first) - 1, vertices.FindIndex(last) - 1};
        e.range.closed = e.vertex[0] == e.vertex[1];
        if (!e.is_degenerated()) e.length = GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(e.edge));
        edges_.push_back(e);
    }
    std::vector<std::int32_t> broken;
    for (int i = 1; i <= faces.Extent(); ++i) {
        CadFace f = read_face(TopoDS::Face(faces(i)));
        if (f.surface.IsNull()) broken.push_back(i - 1);
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(f.face, TopAbs_EDGE, own);
        for (int k = 1; k <= own.Extent(); ++k) {
            const std::int32_t e = edges.FindIndex(own(k)) - 1;
            f.edges.push_back(e);
            CadEdge& edge = edges_[static_cast<std::size_t>(e)];
            edge.faces.push_back(i - 1);
            edge.seam = edge.seam || (!edge.is_degenerated() && BRep_Tool::IsClosed(edge.edge, f.face));
        }
        std::sort(f.edges.begin(), f.edges.end());
        faces_.push_back(std::move(f));
    }
    if (!broken.empty()) {
        throw Error(ErrorCode::invalid_shape, name_ + " has faces without a surface: " + names("Face", broken) + ".",
                    ElementKind::cad_face, broken);
    }
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape_, box, Standard_False, Standard_False);
    diagonal_ = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

std::string CadShape::names(const char* kind, std::span<const std::int32_t> ids) {
    std::string text;
    for (std::size_t i = 0; i < std::min(ids.size(), kMostNames); ++i) {
        if (i > 0) text += ", ";
        text += kind + std::to_string(ids[i] + 1);
    }
    return ids.size() > kMostNames ? text + ", …" : text;
}

std::vector<std::int32_t> invalid_faces(const CadShape& shape) {
    std::vector<std::int32_t> broken;
    for (std::size_t i = 0; i < shape.faces().size(); ++i) {
        bool valid = false;
        try {
            valid = BRepCheck_Analyzer(shape.faces()[i].face).IsValid() == Standard_True;
        } catch (const Standard_Failure&) {  // what it can't even look at is broken
        }
        if (!valid) broken.push_back(static_cast<std::int32_t>(i));
    }
    return broken;
}

void check_shape(const CadShape& shape) {
    const std::vector<std::int32_t> broken = invalid_faces(shape);
    if (broken.empty()) return;
    throw Error(ErrorCode::invalid_shape,
                shape.name() + " has invalid faces: " + CadShape::names("Face", broken) +
                    ". Mend the shape, or take them as they are with the option repair.",
                ElementKind::cad_face, broken);
}

}  // namespace anisoquad::cad
