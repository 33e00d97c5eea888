#include "cad/face_samples.h"

#include <Geom_BSplineSurface.hxx>
#include <algorithm>

#include "cad/to_eigen.h"

namespace anisoquad::cad {
namespace {

constexpr int kSamples = 24;  ///< a direction, at the least
constexpr int kSamplesPerSpan = 4;

void make(const CadFace& face, FaceSamples& samples) {
    int spans[2] = {1, 1};
    if (const Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(face.surface); !spline.IsNull()) {
        spans[0] = spline->NbUKnots() - 1;
        spans[1] = spline->NbVKnots() - 1;
    }
    const int n[2] = {std::max(kSamples, kSamplesPerSpan * spans[0]), std::max(kSamples, kSamplesPerSpan * spans[1])};
    const auto& [u, v] = face.range;
    for (int i = 0; i <= n[0]; ++i) {
        for (int k = 0; k <= n[1]; ++k) {
            const Eigen::Vector2d x(u.low + (u.high - u.low) * i / n[0], v.low + (v.high - v.low) * k / n[1]);
            samples.points.push_back(to_eigen(face.surface->Value(x[0], x[1])));
            samples.parameters.push_back(x);
        }
    }
}

}  // namespace

const FaceSamples& samples_of(const CadFace& face) {
    FaceSamples& samples = *face.samples;
    std::call_once(samples.once, [&] { make(face, samples); });
    return samples;
}

}  // namespace anisoquad::cad
