#pragma once

#include <span>
#include <vector>

#include "cleanup/region.h"
#include "cleanup/sectors.h"

namespace anisoquad {

/// Tries replacements: counts what they gain, makes them, smooths round them, and takes them back where elements get too poor.
class Trial {
  public:
    struct Demands {
        int gain = 1;               ///< least fall of the irregularity
        double bound = 0.4;         ///< scaled Jacobian: the worst element may fall to it
        double improvement = 0.0;   ///< > 0: the worst element must get better by this, or in sum those that lack something
        double count_change = 2.0;  ///< quads that may come or go in any case
        double deficit = 0.0;       ///< > 0: what elements lack to be of use must fall by this in sum
        double nearer = 1.0;        ///< < 1: the distance from the surface must fall to this share of what it was
        /// Nodes may stay in the mesh between their neighbours where that leaves fewer inverted quads, as near to the surface as
        /// all else has to be: lines that are nearer to each other than to their edges leave no room on the surface between them.
        bool may_leave_surface = false;
        bool may_fold = false;  ///< neighbours may be turned by more than a right angle where that leaves fewer inverted quads
    };

    /// Scaled Jacobian up to which a quad is inverted, but for rounding, or has a corner of 180°.
    static constexpr double kUpright = 1e-4;

    Trial(SurfaceMesh& mesh, const ReferenceSurface& reference);

    /// What the irregularity (Sectors) of the region's nodes would fall by.
    int gain(const Region& region, const Replacement& replacement) const;

    /// Makes the replacement, smooths, and takes it back if the demands are not met, if sizes or the distance from the surface
    /// change too much or quads get stretched.
    /// @param region its faces; the rest is filled in; afterwards the new quads, or the old ones with their old handles
    bool attempt(Region& region, const Replacement& replacement, const Demands& demands);

    /// Number of replacements that were made, also those taken back.
    std::size_t tries() const { return tries_; }
    /// Number of quads that they were judged by, all together: the work done.
    std::size_t work() const { return work_; }
    const Sectors& sectors() const { return sectors_; }
    RegionEditor& editor() { return editor_; }
    const SurfaceMesh& mesh() const { return mesh_; }

  private:
    struct Quality {
        double worst = 1.0;     ///< scaled Jacobian, negative where turned over
        double mean = 1.0;      ///< of the scaled Jacobian
        int inverted = 0;       ///< elements that are turned over or have a corner of 180°
        int folds = 0;          ///< see count_folds()
        double deficit = 0.0;   ///< sum of what elements lack to be of use
        double lack = 0.0;      ///< sum of what elements lack to be good enough
        double aspect = 1.0;    ///< largest ratio of longest to shortest edge
        double distance = 0.0;  ///< of the quads' middles and edges from the surface
    };
    Quality quality(std::span<const Face> faces);
    bool is_acceptable(const Quality& before, const Quality& after, const Demands& demands) const;
    /// The region's faces and those round the nodes of its outline.
    void gather_neighbourhood(const Region& region, std::vector<Face>& faces);
    /// @param sheet of the surface onto which the nodes go; nullptr: they stay in the mesh between their neighbours
    void smooth(const Region& region, const Sheet* sheet);
    void restore_outline();

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    Sectors sectors_;
    RegionEditor editor_;
    Marks marks_;
    std::int32_t hint_ = -1;  ///< facet near what was looked at last, which is near what is looked at next
    std::size_t tries_ = 0;
    std::size_t work_ = 0;
    std::vector<Face> faces_;
    std::vector<std::pair<Vertex, Replacement::Node>> places_;  ///< of nodes that smoothing may move, from before
};

}  // namespace anisoquad
