#include "anisotropy/geodesic_trace.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "qmorph/front.h"

namespace anisoquad {

using M = SurfaceMesh;
using Eigen::Vector3d;

TraceEnd trace_geodesic(const SurfaceMesh& mesh, HalfEdge in, double angle, double length) {
    const Point& origin = mesh.position(mesh.to(in));
    TraceEnd end;
    // The triangle of the sector in which the line starts.
    HalfEdge entry;
    Vector3d direction;
    for (double sum = 0.0;;) {
        const HalfEdge spoke = mesh.next(in);
        const Vector3d a = mesh.position(mesh.from(in)) - origin;
        const Vector3d b = mesh.position(mesh.to(spoke)) - origin;
        const double here = std::atan2(a.cross(b).norm(), a.dot(b));
        if (sum + here >= angle || is_front(mesh, spoke)) {
            const double x = std::clamp(angle - sum, 0.02 * here, 0.98 * here);
            direction = (a.normalized() * std::sin(here - x) + b.normalized() * std::sin(x)).normalized();
            entry = mesh.next(spoke);
            break;
        }
        sum += here;
        in = M::twin(spoke);
    }
    // First triangle: up to the edge opposite to the origin.
    const Vector3d first = mesh.position(mesh.from(entry)) - origin;
    const Vector3d second = mesh.position(mesh.to(entry)) - origin;
    const double t = second.cross(first).norm() / (direction.cross(first - second)).norm();
    end.face = mesh.face(entry);
    if (!(t < length)) {
        end.position = origin + length * direction;
        end.length = length;
        return end;
    }
    Point p = origin + t * direction;
    double way = t;
    HalfEdge exit = entry;  // half-edge, in the face that is left, through which the line goes
    for (int steps = 0; steps < 100000; ++steps) {
        if (is_front(mesh, exit) || mesh.is_constrained(M::edge(exit)) || !mesh.is_triangle(mesh.face(M::twin(exit)))) {
            end.position = p;
            end.length = way;
            end.blocked = true;
            end.incidence =
                direction.cross(mesh.position(mesh.to(exit)) - mesh.position(mesh.from(exit))).norm() / mesh.length(exit);
            return end;
        }
        const HalfEdge e = M::twin(exit);
        const Point& a = mesh.position(mesh.from(e));
        const Vector3d along = (mesh.position(mesh.to(e)) - a).normalized();
        const Vector3d to_apex = mesh.position(mesh.to(mesh.next(e))) - a;
        const double dx = std::clamp(direction.dot(along), -0.999999, 0.999999);
        const double dy = std::sqrt(1.0 - dx * dx);
        const Vector3d up = (to_apex - to_apex.dot(along) * along).normalized();
        const double px = (p - a).dot(along);
        const double cx = to_apex.dot(along);
        const double cy = to_apex.dot(up);
        direction = dx * along + dy * up;
        end.face = mesh.face(e);
        // Apex left of the line: it leaves through the edge on the right, else through the one on the left.
        const bool right = dx * cy - dy * (cx - px) > 0.0;
        exit = right ? mesh.next(e) : mesh.prev(e);
        const double qx = right ? (mesh.position(mesh.to(e)) - a).norm() : 0.0;
        // Intersection of p + s·d with the segment q → apex.
        const double ex = cx - qx;
        const double det = dx * cy - dy * ex;
        const double s = std::abs(det) > 0.0 ? std::max(0.0, ((qx - px) * cy) / det) : 0.0;
        if (way + s >= length) {
            end.position = p + (length - way) * direction;
            end.length = length;
            return end;
        }
        way += s;
        p += s * direction;
    }
    end.position = p;
    end.length = way;
    end.blocked = true;
    return end;
}

}  // namespace anisoquad
