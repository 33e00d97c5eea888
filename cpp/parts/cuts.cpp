#include "parts/cuts.h"

#include <algorithm>
#include <cmath>

namespace anisoquad {

bool Cuts::is_near(const Point& p, double distance) const {
    return std::any_of(cuts_.begin(), cuts_.end(), [&](const Cut& cut) {
        return std::abs(p[cut.axis] - cut.place) <= distance && cut.box.squaredExteriorDistance(p) <= distance * distance;
    });
}

}  // namespace anisoquad
