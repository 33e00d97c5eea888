#include "cleanup/region_growth.h"

#include <algorithm>

#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr int kMostSides = Sides::kMost;

int inside(const SurfaceMesh& mesh, const Region& region, std::size_t i) {
    const HalfEdge last = M::twin(region.loop[(i + region.loop.size() - 1) % region.loop.size()]);
    int n = 1;
    for (HalfEdge k = mesh.rotated_ccw(region.loop[i]); k != last; k = mesh.rotated_ccw(k)) ++n;
    return n;
}

}  // namespace

int RegionGrowth::wanted_inside(const Region& region, std::size_t i) const {
    const SurfaceMesh& mesh = trial_.mesh();
    const Sectors::Count count = trial_.sectors().count(mesh, region.loop[i]);
    return count.ideal - (count.quads - inside(mesh, region, i));
}

/// Adds the faces of the sector of from(h) that holds face(h).
void RegionGrowth::add_faces_at(HalfEdge h, Region& region) {
    const SurfaceMesh& mesh = trial_.mesh();
    const auto add = [&](Face f) {
        if (faces_.mark(f)) region.faces.push_back(f);
    };
    add(mesh.face(h));
    HalfEdge k = h;
    while (!is_fixed(mesh, M::edge(k))) {
        k = mesh.rotated_cw(k);
        add(mesh.face(k));
        if (k == h) return;
    }
    for (k = mesh.rotated_ccw(h); !is_fixed(mesh, M::edge(k)); k = mesh.rotated_ccw(k)) add(mesh.face(k));
}

bool RegionGrowth::make_convex(Region& region, const Limits& limits) {
    for (;;) {
        if (region.faces.size() > limits.faces || !trial_.editor().trace_outline(region)) return false;
        const std::size_t size = region.faces.size();
        for (std::size_t i = 0; i < region.loop.size(); ++i) {
            if (wanted_inside(region, i) > 2) add_faces_at(region.loop[i], region);
        }
        if (region.faces.size() == size) return trial_.editor().find_inner(region);
    }
}

bool RegionGrowth::grow_to_next(Region& region, const Limits& limits) {
    const SurfaceMesh& mesh = trial_.mesh();
    reached_.clear(mesh.face_slots());
    front_ = region.faces;
    from_.assign(front_.size(), Face());
    for (const Face f : front_) reached_.mark(f);
    const std::size_t inner = front_.size();
    // An irregular node of the outline comes first: all its faces.
    for (const HalfEdge h : region.loop) {
        if (trial_.sectors().count(mesh, h).cost() == 0) continue;
        const std::size_t before = region.faces.size();
        add_faces_at(h, region);
        if (region.faces.size() > before) return true;
    }
    for (std::size_t i = 0; i < front_.size() && front_.size() < inner + 4 * limits.faces; ++i) {
        const Face f = front_[i];
        for (const HalfEdge h : mesh.halfedges(f)) {
            const Face other = mesh.face(M::twin(h));
            if (is_fixed(mesh, M::edge(h)) || !reached_.mark(other)) continue;
            front_.push_back(other);
            from_.push_back(f);
        }
        if (i < inner) continue;
        for (const HalfEdge h : mesh.halfedges(f)) {
            if (trial_.sectors().count(mesh, h).cost() == 0) continue;
            add_faces_at(h, region);
            // The way back to the region.
            std::size_t k = i;
            while (k >= inner) {
                if (faces_.mark(front_[k])) region.faces.push_back(front_[k]);
                k = static_cast<std::size_t>(std::find(front_.begin(), front_.end(), from_[k]) - front_.begin());
            }
            return true;
        }
    }
    return false;
}

bool RegionGrowth::try_patch(Region& region, const Trial::Demands& demands) {
    const SurfaceMesh& mesh = trial_.mesh();
    const std::size_t n = region.loop.size();
    std::vector<std::size_t> corners;
    int cost = 0;
    int least = 0;  // what stays on the outline
    double size = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const int wanted = wanted_inside(region, i);
        if (wanted <= 1) corners.push_back(i);
        Sectors::Count count = trial_.sectors().count(mesh, region.loop[i]);
        cost += count.cost();
        count.quads += (wanted <= 1 ? 1 : 2) - inside(mesh, region, i);
        least += count.cost();
        size += mesh.info(mesh.from(region.loop[i])).size;
    }
    const int sides = static_cast<int>(corners.size());
    if (sides < 2 || sides > kMostSides) return false;
    for (const Vertex v : region.inner) cost += irregularity(mesh.valence(v));
    const int budget = std::min(cost - least - demands.gain, 3);
    if (budget < std::abs(sides - 4)) return false;
    Sides counts;
    std::vector<std::vector<Vertex>> lines;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t from = corners[c];
        const std::size_t to = corners[(c + 1) % corners.size()];
        std::vector<Vertex>& line = lines.emplace_back();
        std::size_t i = from;
        do {
            line.push_back(mesh.from(region.loop[i]));
            i = (i + 1) % n;
        } while (i != to);
        line.push_back(mesh.from(region.loop[to]));
        counts.push_back(static_cast<int>(line.size()) - 1);
    }
    if (!planner_.plan(counts, budget).is_possible()) return false;
    const Replacement patch = mesh_patch(mesh, planner_, lines, budget, size / static_cast<double>(n));
    return trial_.attempt(region, patch, demands);
}

/// The faces of the irregular sector of the seed.
bool RegionGrowth::begin(Vertex seed, Region& region) {
    const SurfaceMesh& mesh = trial_.mesh();
    faces_.clear(mesh.face_slots());
    region.faces.clear();
    for (const HalfEdge h : mesh.outgoing(seed)) {
        if (mesh.is_boundary(h) || mesh.info(mesh.face(h)).row > 0) continue;
        if (trial_.sectors().count(mesh, h).cost() == 0) continue;
        add_faces_at(h, region);
        return true;
    }
    return false;
}

void RegionGrowth::add_ring(Region& region) {
    for (const HalfEdge h : region.loop) add_faces_at(h, region);
}

bool RegionGrowth::improve(Vertex seed, const Limits& limits, Region& region) {
    if (!begin(seed, region)) return false;
    for (int step = 0; step < limits.steps && make_convex(region, limits); ++step) {
        if (try_patch(region, limits.demands)) return true;
        if (!trial_.editor().find_outline(region) || !grow_to_next(region, limits)) break;
    }
    begin(seed, region);
    for (int ring = 0; ring < limits.rings && make_convex(region, limits); ++ring) {
        if (try_patch(region, limits.demands)) return true;
        if (!trial_.editor().find_outline(region)) break;
        add_ring(region);
    }
    return false;
}

}  // namespace anisoquad
