#pragma once

#include <Eigen/Core>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace anisoquad::cad {

inline Eigen::Vector3d to_eigen(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Eigen::Vector3d to_eigen(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }
inline gp_Pnt to_occ(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace anisoquad::cad
