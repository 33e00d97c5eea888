#include "parts/partition.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "mesh/face_middle.h"

namespace anisoquad {
namespace {

constexpr double kLeastStarts = 0.3;  ///< faces from which the work begins, over √ of all: half of what one side of a square has

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Partitioner {
  public:
    Partitioner(const SurfaceMesh& mesh, const std::function<bool(Face)>& is_start, const Context& context, std::int32_t most)
        : mesh_(mesh), is_start_(is_start), context_(context), most_(most) {}

    Partition run() {
        result_.part_of_face.assign(at(mesh_.face_slots()), -1);
        std::vector<Face> faces;
        for (std::int32_t f = 0; f < mesh_.face_slots(); ++f) {
            if (!mesh_.is_deleted(Face(f))) faces.emplace_back(f);
        }
        if (!faces.empty()) bisect(faces, {});
        return std::move(result_);
    }

  private:
    static std::int32_t size(std::span<const Face> faces) { return static_cast<std::int32_t>(faces.size()); }

    /// @param faces whose order changes
    void bisect(std::span<Face> faces, const Cuts& cuts) {
        if (size(faces) > most_) {
            Eigen::AlignedBox3d box;
            for (const Face f : faces) box.extend(face_middle(mesh_, f));
            context_.breathe();
            int axis = 0;
            box.sizes().maxCoeff(&axis);
            const double cut = halve(faces, axis);
            context_.breathe();
            const auto middle = faces.begin() + size(faces) / 2;
            const std::span<Face> low(faces.begin(), middle);
            const std::span<Face> high(middle, faces.end());
            if (is_worth_it(low) && is_worth_it(high)) {
                Cuts more = cuts;
                more.add(axis, cut, box);
                result_.all_cuts.add(axis, cut, box);
                bisect(low, more);
                bisect(high, more);
                return;
            }
        }
        for (const Face f : faces) result_.part_of_face[at(f.index())] = result_.parts;
        result_.cuts.push_back(cuts);
        ++result_.parts;
    }

    /// The lower ones along an axis first. @returns the place of the first one of the upper half
    double halve(std::span<Face> faces, int axis) {
        std::vector<std::pair<double, Face>> places;
        places.reserve(faces.size());
        for (const Face f : faces) places.emplace_back(face_middle(mesh_, f)[axis], f);
        const auto middle = places.begin() + size(faces) / 2;
        context_.breathe();
        std::nth_element(places.begin(), middle, places.end());
        std::transform(places.begin(), places.end(), faces.begin(), [](const auto& place) { return place.second; });
        return middle->first;
    }

    bool is_worth_it(std::span<const Face> faces) const {
        const auto starts = static_cast<double>(std::count_if(faces.begin(), faces.end(), is_start_));
        return starts >= kLeastStarts * std::sqrt(static_cast<double>(faces.size()));
    }

    const SurfaceMesh& mesh_;
    const std::function<bool(Face)>& is_start_;
    const Context& context_;
    const std::int32_t most_;
    Partition result_;
};

}  // namespace

Partition make_partition(const SurfaceMesh& mesh, const std::function<bool(Face)>& is_start, const Context& context,
                         std::int32_t most) {
    return Partitioner(mesh, is_start, context, most).run();
}

}  // namespace anisoquad
