#pragma once

#include <Eigen/Core>

#include "cad/shape.h"

namespace anisoquad::cad {

/// Closest point of a face's surface within the face's range of parameters (its trimming curves are not looked at).
struct FacePoint {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector2d parameter = Eigen::Vector2d::Zero();
    double distance = 0.0;
    bool converged = false;
};

struct EdgePoint {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double parameter = 0.0;
    double distance = 0.0;
    bool converged = false;
};

/// From a start near by: Newton's method for the least distance, damped, held in the range. Parameters of a periodic direction
/// run on over the ends of the range; at an end of a closed direction that is not periodic the search goes on at the other end.
FacePoint closest_on_face(const CadFace& face, const Eigen::Vector3d& p, const Eigen::Vector2d& start);
/// From nowhere: the best of a grid of starts. A hundred times slower.
FacePoint closest_on_face(const CadFace& face, const Eigen::Vector3d& p);
/// Unit normal of the face at a parameter, out of the shape's material; zero at a pole.
Eigen::Vector3d face_normal(const CadFace& face, const Eigen::Vector2d& parameter);

/// The same on an edge. @pre the edge is not degenerated
EdgePoint closest_on_edge(const CadEdge& edge, const Eigen::Vector3d& p, double start);
EdgePoint closest_on_edge(const CadEdge& edge, const Eigen::Vector3d& p);

}  // namespace anisoquad::cad
