#include "prepare/source_spacing.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace anisoquad {
namespace {

constexpr double kStep = 0.9;  ///< from one length that is tried to the next
constexpr double kStraightOn =
    -0.89;  ///< cosine (153°) between lines of which one goes on where the other ends: no column runs there

/// Direction of a chain at one of its ends, away from it.
Eigen::Vector3d direction(const SurfaceMesh& mesh, const LineNodes& chain, bool front) {
    const std::size_t n = chain.nodes.size();
    const Point& end = mesh.position(front ? chain.nodes[0] : chain.nodes[n - 1]);
    return (mesh.position(front ? chain.nodes[1] : chain.nodes[n - 2]) - end).normalized();
}

/// Longest edge from one end of a line that stays near it.
double first_edge(const LineNodes& chain, bool front, const ReferenceLines& reference, const SourceSpacingOptions& options) {
    const double length = reference.length(chain.line);
    double way = std::min(options.longest, length);
    while (way > options.shortest &&
           reference.deviation(chain.line, front ? 0.0 : length - way, front ? way : length) > options.deviation)
        way *= kStep;
    return std::max(way, options.shortest);
}

}  // namespace

double source_spacing(const SurfaceMesh& mesh, std::span<const LineNodes> chains, std::span<const FeatureLine> lines,
                      const ReferenceLines& reference, std::int32_t source, const SourceSpacingOptions& options) {
    const auto source_of = [&](const LineNodes& chain) { return lines[static_cast<std::size_t>(chain.line)].source; };
    double spacing = options.longest;
    for (const LineNodes& own : chains) {
        if (source_of(own) != source || own.nodes.size() < 2) continue;
        for (const bool own_front : {true, false}) {
            const Vertex end = own_front ? own.nodes.front() : own.nodes.back();
            const Eigen::Vector3d along = direction(mesh, own, own_front);
            for (const LineNodes& chain : chains) {
                // Of a single edge a column finds no node before the corner: there will be no rows on that side.
                if (source_of(chain) == source || chain.nodes.size() < 3) continue;
                for (const bool front : {true, false}) {
                    if ((front ? chain.nodes.front() : chain.nodes.back()) != end) continue;
                    if (along.dot(direction(mesh, chain, front)) > kStraightOn)
                        spacing = std::min(spacing, first_edge(chain, front, reference, options));
                }
            }
        }
    }
    return spacing;
}

}  // namespace anisoquad
