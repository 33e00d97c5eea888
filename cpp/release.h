#pragma once

#include <vector>

namespace anisoquad {

/// Gives a vector's memory back, which an assignment of {} keeps.
template <class T>
void release(std::vector<T>& v) {
    std::vector<T>().swap(v);
}

}  // namespace anisoquad
