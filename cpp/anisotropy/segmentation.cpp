#include "anisotropy/segmentation.h"

#include <algorithm>

namespace anisoquad {

std::vector<int> segment_open(int edges, int ratio, RampStart start) {
    const auto ramp = [](int first, int k) { return first < k ? (k - first) * (k + first - 1) / 2 : 0; };  // first … k − 1
    const auto ramps = [&](int k) { return ramp(start.front, k) + ramp(start.back, k); };
    while (ratio > 1 && ramps(ratio) + ratio > edges) --ratio;
    if (ratio <= 1) return std::vector<int>(static_cast<std::size_t>(edges), 1);
    const int middle = edges - ramps(ratio);
    const int whole = middle / ratio;
    const int rest = middle % ratio;
    std::vector<int> segments;
    for (int k = start.front; k < ratio; ++k) segments.push_back(k);
    segments.insert(segments.end(), static_cast<std::size_t>(whole), ratio);
    for (int k = ratio - 1; k >= start.back; --k) segments.push_back(k);
    if (rest == 0) return segments;
    // What is shorter than both ramps' first segments goes where it is far from either.
    auto place = segments.begin() + static_cast<std::ptrdiff_t>(segments.size() / 2);
    if (rest >= start.back) {
        place = std::find_if(segments.rbegin(), segments.rend(), [&](int k) { return k >= rest; }).base();
    } else if (rest >= start.front) {
        place = std::find_if(segments.begin(), segments.end(), [&](int k) { return k >= rest; });
    }
    segments.insert(place, rest);
    return segments;
}

std::vector<int> segment_closed(int edges, int ratio) {
    int count = std::max(1, (edges + ratio / 2) / ratio);
    if (count % 2 != 0) count = count + 1 <= edges ? count + 1 : count - 1;
    count = std::clamp(count, std::min(edges, 4), edges);
    std::vector<int> segments;
    for (int i = 0; i < count; ++i) segments.push_back((i + 1) * edges / count - i * edges / count);
    return segments;
}

std::vector<int> refine_segments(const std::vector<int>& segments, const std::function<bool(int, int)>& accept) {
    std::vector<int> result;
    const auto add = [&](const auto& self, int first, int length) -> void {
        if (length <= 1 || accept(first, first + length)) {
            result.push_back(length);
            return;
        }
        self(self, first, length / 2);
        self(self, first + length / 2, length - length / 2);
    };
    int first = 0;
    for (const int length : segments) {
        add(add, first, length);
        first += length;
    }
    return result;
}

}  // namespace anisoquad
