#include "anisotropy/segmentation.h"

#include <algorithm>

namespace anisoquad {

std::vector<int> segment_open(int edges, int ratio) {
    const auto ramps = [](int k) { return k * (k - 1); };  // both ramps 1 … k − 1
    while (ratio > 1 && ramps(ratio) + ratio > edges) --ratio;
    if (ratio <= 1) return std::vector<int>(static_cast<std::size_t>(edges), 1);
    std::vector<int> segments;
    for (int k = 1; k < ratio; ++k) segments.push_back(k);
    const int middle = edges - ramps(ratio);
    for (int i = 0; i < middle / ratio; ++i) segments.push_back(ratio);
    const int rest = middle % ratio;
    for (int k = ratio - 1; k >= 1; --k) {
        if (k == rest) segments.push_back(rest);
        segments.push_back(k);
    }
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
