#pragma once

#include <span>
#include <vector>

#include "cleanup/region.h"
#include "cleanup/sectors.h"

namespace anisoquad {

/// Tries replacements: counts what they gain, makes them, smooths round them, and takes them back where elements get too poor.
class Trial {
  public:
    Trial(SurfaceMesh& mesh, const ReferenceSurface& reference);

    /// What the irregularity (Sectors) of the region's nodes would fall by.
    int gain(const Region& region, const Replacement& replacement) const;

    /// Makes the replacement if it gains at least `least_gain` and the worst element, after smoothing, is not below the lower of
    /// what it was and `bound`. @param region its faces; the rest is filled in; afterwards the new quads
    bool attempt(Region& region, const Replacement& replacement, int least_gain, double bound);

    const Sectors& sectors() const { return sectors_; }
    RegionEditor& editor() { return editor_; }
    const SurfaceMesh& mesh() const { return mesh_; }

  private:
    struct Quality {
        double worst = 1.0;    ///< scaled Jacobian, negative where turned over
        double aspect = 1.0;   ///< largest ratio of longest to shortest edge
    };
    Quality quality(std::span<const Face> faces) const;
    double scaled_jacobian_on_surface(Face f) const;
    /// The region's faces and those round the nodes of its outline.
    void gather_neighbourhood(const Region& region, std::vector<Face>& faces);
    void smooth(const Region& region);

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    Sectors sectors_;
    RegionEditor editor_;
    Marks marks_;
    std::vector<Face> faces_;
    std::vector<std::pair<Vertex, Replacement::Node>> places_;  ///< of nodes that smoothing may move, from before
};

}  // namespace anisoquad
