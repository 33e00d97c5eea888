#include "parts/partition.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "mesh/face_middle.h"
#include "parallel.h"

namespace anisoquad {
namespace {

constexpr double kLeastStarts = 0.3;  ///< faces from which the work begins, over √ of all: half of what one side of a square has

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Partitioner {
  public:
    Partitioner(const SurfaceMesh& mesh, const std::function<bool(Face)>& is_start, const Context& context, std::int32_t most)
        : mesh_(mesh), context_(context), most_(most), is_start_(at(mesh.face_slots()), 0) {
        for_each(mesh.face_slots(), context, [&](std::int32_t f) {
            if (!mesh.is_deleted(Face(f))) is_start_[at(f)] = is_start(Face(f)) ? 1 : 0;
        });
    }

    Partition run() {
        std::vector<Face> faces;
        for (std::int32_t f = 0; f < mesh_.face_slots(); ++f) {
            if (!mesh_.is_deleted(Face(f))) faces.emplace_back(f);
        }
        Partition result;
        std::vector<Piece> pieces;
        if (!faces.empty()) pieces.push_back({faces, {}});
        while (halve_all(pieces, result.all_cuts)) {
        }
        result.part_of_face.assign(at(mesh_.face_slots()), -1);
        for (const Piece& piece : pieces) {
            for (const Face f : piece.faces) result.part_of_face[at(f.index())] = result.parts;
            result.cuts.push_back(piece.cuts);
            ++result.parts;
        }
        return result;
    }

  private:
    struct Piece {
        std::span<Face> faces;
        Cuts cuts;
        bool is_part = false;  ///< not to be halved any more
    };
    struct Cut {
        int axis;
        double place;
        Eigen::AlignedBox3d box;
    };

    /// Of each piece in its turn the lower half, then the upper one; pieces that are not worth it stay as they are.
    /// @returns false if all do
    bool halve_all(std::vector<Piece>& pieces, Cuts& all_cuts) const {
        std::vector<std::optional<Cut>> cuts(pieces.size());
        for_each_task(static_cast<std::int32_t>(pieces.size()), context_, [&](std::int32_t i) {
            if (!pieces[at(i)].is_part && size(pieces[at(i)].faces) > most_) cuts[at(i)] = halve(pieces[at(i)].faces);
        });
        std::vector<Piece> halves;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            Piece& piece = pieces[i];
            if (!cuts[i]) {
                piece.is_part = true;
                halves.push_back(std::move(piece));
                continue;
            }
            const auto& [axis, place, box] = *cuts[i];
            piece.cuts.add(axis, place, box);
            all_cuts.add(axis, place, box);
            halves.push_back({lower_half(piece.faces), piece.cuts});
            halves.push_back({upper_half(piece.faces), piece.cuts});
        }
        pieces = std::move(halves);
        return std::any_of(cuts.begin(), cuts.end(), [](const auto& cut) { return cut.has_value(); });
    }

    static std::int32_t size(std::span<const Face> faces) { return static_cast<std::int32_t>(faces.size()); }
    static std::span<Face> lower_half(std::span<Face> faces) { return faces.first(faces.size() / 2); }
    static std::span<Face> upper_half(std::span<Face> faces) { return faces.subspan(faces.size() / 2); }

    /// Those that lie lower along the longest extent first. @returns nothing if the halves are not worth it
    std::optional<Cut> halve(std::span<Face> faces) const {
        Eigen::AlignedBox3d box;
        for (const Face f : faces) box.extend(face_middle(mesh_, f));
        int axis = 0;
        box.sizes().maxCoeff(&axis);
        std::vector<std::pair<double, Face>> places(faces.size());
        for_each(size(faces), [&](std::int32_t i) { places[at(i)] = {face_middle(mesh_, faces[at(i)])[axis], faces[at(i)]}; });
        const auto middle = places.begin() + size(faces) / 2;
        std::nth_element(places.begin(), middle, places.end());
        std::transform(places.begin(), places.end(), faces.begin(), [](const auto& place) { return place.second; });
        if (!is_worth_it(lower_half(faces)) || !is_worth_it(upper_half(faces))) return std::nullopt;
        return Cut{axis, middle->first, box};
    }

    bool is_worth_it(std::span<const Face> faces) const {
        const auto starts = std::count_if(faces.begin(), faces.end(), [this](Face f) { return is_start_[at(f.index())] != 0; });
        return static_cast<double>(starts) >= kLeastStarts * std::sqrt(static_cast<double>(faces.size()));
    }

    const SurfaceMesh& mesh_;
    const Context& context_;
    const std::int32_t most_;
    std::vector<char> is_start_;  ///< per face slot
};

}  // namespace

Partition make_partition(const SurfaceMesh& mesh, const std::function<bool(Face)>& is_start, const Context& context,
                         std::int32_t most) {
    return Partitioner(mesh, is_start, context, most).run();
}

}  // namespace anisoquad
