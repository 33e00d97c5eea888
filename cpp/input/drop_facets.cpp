#include "input/drop_facets.h"

#include <algorithm>
#include <vector>

namespace anisoquad {
namespace {

using Triangle = std::array<std::int32_t, 3>;

template <class Predicate>
std::int32_t drop_if(TriangleSoup& soup, Predicate predicate) {
    return static_cast<std::int32_t>(std::erase_if(soup.triangles, predicate));
}

/// Drops all but the first facet of those with the same key.
template <class Key>
std::int32_t drop_later(TriangleSoup& soup, Key key) {
    struct Keyed {
        Triangle key;
        std::size_t facet;
        bool operator<(const Keyed& other) const { return key != other.key ? key < other.key : facet < other.facet; }
    };
    std::vector<Keyed> sorted;
    sorted.reserve(soup.triangles.size());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) sorted.push_back({key(soup.triangles[f]), f});
    std::sort(sorted.begin(), sorted.end());
    std::vector<char> gone(soup.triangles.size(), 0);
    for (std::size_t i = 1; i < sorted.size(); ++i) gone[sorted[i].facet] = sorted[i].key == sorted[i - 1].key;
    std::size_t f = 0;
    return drop_if(soup, [&](const Triangle&) { return gone[f++] != 0; });
}

}  // namespace

std::int32_t drop_out_of_range(TriangleSoup& soup) {
    const auto n = static_cast<std::int32_t>(soup.points.size());
    return drop_if(soup,
                   [n](const Triangle& t) { return std::any_of(t.begin(), t.end(), [n](auto v) { return v < 0 || v >= n; }); });
}

std::int32_t drop_non_finite(TriangleSoup& soup) {
    return drop_if(soup, [&](const Triangle& t) {
        return std::any_of(t.begin(), t.end(), [&](auto v) { return !soup.point(v).allFinite(); });
    });
}

std::int32_t drop_repeated_corners(TriangleSoup& soup) {
    return drop_if(soup, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

std::int32_t drop_duplicates(TriangleSoup& soup) {
    return drop_later(soup, [](Triangle t) {
        std::sort(t.begin(), t.end());
        return t;
    });
}

std::int32_t drop_doubled(TriangleSoup& soup, std::span<const std::int32_t> place) {
    return drop_later(soup, [&](const Triangle& t) {
        Triangle at = t;
        for (auto& v : at) v = place[static_cast<std::size_t>(v)];
        std::rotate(at.begin(), std::min_element(at.begin(), at.end()), at.end());
        return at;
    });
}

}  // namespace anisoquad
