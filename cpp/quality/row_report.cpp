#include "quality/row_report.h"

#include <algorithm>
#include <tuple>

namespace anisoquad {
namespace {

using M = SurfaceMesh;

enum Side : std::uint8_t { left, right, both };
constexpr const char* kSideNames[] = {"left", "right", "both"};

/// One quad of a row.
struct Cell {
    std::int32_t source;
    Side side;
    std::int32_t row;
    std::int32_t pass;
    double along;
    double height;
    std::int32_t face;
    auto row_key() const { return std::tie(source, side, row); }
};

class RowWalker {
  public:
    RowWalker(const SurfaceMesh& mesh, std::span<const Source> sources)
        : mesh_(mesh), sources_(sources), seen_(static_cast<std::size_t>(mesh.face_slots()), 0) {
        for (const Source& source : sources) {
            std::vector<Place>& places = places_.emplace_back();
            const bool closed = source.vertices.size() > 1 && source.vertices.front() == source.vertices.back();
            for (std::size_t i = 0; i + (closed ? 1 : 0) < source.vertices.size(); ++i) {
                places.push_back({source.vertices[i], static_cast<std::int32_t>(i)});
            }
            std::sort(places.begin(), places.end());
        }
    }

    std::vector<RowReport> run() {
        for (std::int32_t i = 0; i < mesh_.halfedge_slots(); ++i) {
            const HalfEdge h(i);
            if (!mesh_.is_deleted(h) && mesh_.info(M::edge(h)).source) walk_column(h);
        }
        std::sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
            return a.row_key() != b.row_key() ? a.row_key() < b.row_key() : a.face < b.face;
        });
        return rows();
    }

  private:
    struct Place {
        std::int32_t vertex;
        std::int32_t index;  ///< in the source
        bool operator<(const Place& other) const { return vertex < other.vertex; }
    };

    /// @param base half-edge of the column's lowest quad, on the source
    void walk_column(HalfEdge base) {
        Side side = both;
        for (std::int32_t row = 1;; ++row) {
            const Face f = mesh_.face(base);
            if (!f.is_valid() || !mesh_.is_quad(f) || mesh_.info(f).row != row || seen_[static_cast<std::size_t>(f.index())])
                return;
            if (row == 1) side = side_of(base, mesh_.info(f).source);
            seen_[static_cast<std::size_t>(f.index())] = 1;
            const HalfEdge top = mesh_.next(mesh_.next(base));
            const double along = 0.5 * (mesh_.length(base) + mesh_.length(top));
            const double height = 0.5 * (mesh_.length(mesh_.next(base)) + mesh_.length(mesh_.prev(base)));
            cells_.push_back({mesh_.info(f).source, side, row, mesh_.info(f).pass, along, height, f.index()});
            base = M::twin(top);
        }
    }

    /// A face lies on the left of its half-edges, so a base along the source's direction is on the left side.
    Side side_of(HalfEdge base, std::int32_t source) const {
        if (source < 0 || source >= static_cast<std::int32_t>(sources_.size())) return both;
        const auto& vertices = sources_[static_cast<std::size_t>(source)].vertices;
        const auto a = place(source, mesh_.info(mesh_.from(base)).input);
        const auto b = place(source, mesh_.info(mesh_.to(base)).input);
        if (a < 0 || b < 0 || a == b) return both;
        if (vertices.front() != vertices.back()) return a < b ? left : right;
        const auto n = static_cast<std::int32_t>(vertices.size()) - 1;
        const std::int32_t ahead = (b - a + n) % n;
        return 2 * ahead < n ? left : right;
    }

    std::int32_t place(std::int32_t source, std::int32_t vertex) const {
        const auto& places = places_[static_cast<std::size_t>(source)];
        const auto found = std::lower_bound(places.begin(), places.end(), Place{vertex, 0});
        return found != places.end() && found->vertex == vertex ? found->index : -1;
    }

    std::vector<RowReport> rows() const {
        std::vector<RowReport> result;
        for (std::size_t i = 0; i < cells_.size();) {
            const Cell& first = cells_[i];
            RowReport row{first.source, kSideNames[first.side], first.row, first.pass, 0, 0.0, 0.0};
            for (; i < cells_.size() && cells_[i].row_key() == first.row_key(); ++i) {
                ++row.quads;
                row.aspect_mean += cells_[i].height > 0.0 ? cells_[i].along / cells_[i].height : 0.0;
                row.height_mean += cells_[i].height;
            }
            row.aspect_mean /= row.quads;
            row.height_mean /= row.quads;
            result.push_back(std::move(row));
        }
        return result;
    }

    const SurfaceMesh& mesh_;
    std::span<const Source> sources_;
    std::vector<std::vector<Place>> places_;  ///< per source: its vertices, sorted
    std::vector<char> seen_;
    std::vector<Cell> cells_;
};

}  // namespace

std::vector<RowReport> measure_rows(const SurfaceMesh& mesh, std::span<const Source> sources) {
    return RowWalker(mesh, sources).run();
}

}  // namespace anisoquad
