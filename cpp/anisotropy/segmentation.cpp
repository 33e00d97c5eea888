#include "anisotropy/segmentation.h"

#include <algorithm>

namespace anisoquad {

std::vector<int> segment_open(int edges, int ratio, RampStart start) {
    const auto ramp = [](int first, int k) { return first < k ? (k - first) * (k + first - 1) / 2 : 0; };  // first … k − 1
    const auto ramps = [&](int k) { return ramp(start.front, k) + ramp(start.back, k); };
    while (ratio > 1 && ramps(ratio) + ratio > edges) --ratio;
    if (ratio <= 1) return std::vector<int>(static_cast<std::size_t>(edges), 1);
    const int middle = edges - ramps(ratio);
    const int rest = middle % ratio;
    const bool in_ramp = rest >= std::min(start.front, start.back);
    std::vector<int> segments;
    for (int k = start.front; k < ratio; ++k) segments.push_back(k);
    // What fits no ramp makes segments shorter, far from both ends.
    const int equal = in_ramp ? middle - rest : middle;
    const int count = (equal + ratio - 1) / ratio;
    const int shorter = count - equal % count;
    const int before = (count - shorter) / 2;
    for (int i = 0; i < count; ++i) segments.push_back(equal / count + (i >= before && i < before + shorter ? 0 : 1));
    for (int k = ratio - 1; k >= start.back; --k) segments.push_back(k);
    if (rest == 0 || !in_ramp) return segments;
    const auto fits = [&](int k) { return k >= rest; };
    const auto place = rest >= start.back ? std::find_if(segments.rbegin(), segments.rend(), fits).base()
                                          : std::find_if(segments.begin(), segments.end(), fits);
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
