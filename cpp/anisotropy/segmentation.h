#pragma once

#include <functional>
#include <vector>

namespace anisoquad {

/// Lengths of the first segments of the ramps at an open source's ends, in edges.
struct RampStart {
    int front = 1;
    int back = 1;
};

/// Lengths of the segments of an open source of `edges` edges (paper 3.2, Fig. 4): 1, 2, 3 … ratio … ratio … 3, 2, 1.
/// What does not fit goes into one more segment of the ramp; a source too short for the ramp gets a lower one.
/// @param start where rows have become too high for columns of one edge, the ramp starts with more
std::vector<int> segment_open(int edges, int ratio, RampStart start = {});

/// Segments of a closed source, without a ramp: as equal as possible, even in number where that can be, so that what remains
/// inside it can be filled with quads.
std::vector<int> segment_closed(int edges, int ratio);

/// Halves segments until each is accepted. @param accept (first edge, one past the last edge) of a segment
std::vector<int> refine_segments(const std::vector<int>& segments, const std::function<bool(int, int)>& accept);

}  // namespace anisoquad
