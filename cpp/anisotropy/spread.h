#pragma once

#include <span>
#include <vector>

namespace anisoquad {

/// Values along a row of nodes, between the given ones at its ends, that are as smooth as the distance from `wanted` allows: the
/// least sum of squared differences plus squared distances over reach². A closed row, which has no ends, is evened out over
/// neighbours.
/// @param value in: its ends, and all values of a closed row; out: all
/// @param wanted as many as values
/// @param reach in columns: how far an end is felt
/// @param closed the first node is the last one too
void spread(std::vector<double>& value, std::span<const double> wanted, double reach, bool closed);

}  // namespace anisoquad
