#pragma once

#include <Eigen/Core>
#include <mutex>
#include <vector>

#include "cad/shape.h"

namespace anisoquad::cad {

/// Points of a face's surface at a grid of parameters, from which searches start.
struct FaceSamples {
    std::vector<Eigen::Vector3d> points;      ///< row by row, v runs faster
    std::vector<Eigen::Vector2d> parameters;  ///< of each
    std::once_flag once;
};

/// The samples of a face, made when they are first asked for: 25 a direction, more where a spline has many spans.
const FaceSamples& samples_of(const CadFace& face);

}  // namespace anisoquad::cad
