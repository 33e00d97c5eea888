#include "anisotropy/spread.h"

namespace anisoquad {
namespace {

constexpr int kSweeps = 8;

void even_out(std::vector<double>& value) {
    const std::size_t n = value.size() - 1;
    std::vector<double> next(value.size());
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (std::size_t i = 0; i <= n; ++i)
            next[i] = 0.5 * value[i] + 0.25 * (value[i > 0 ? i - 1 : n - 1] + value[i < n ? i + 1 : 1]);
        value.swap(next);
    }
}

}  // namespace

void spread(std::vector<double>& value, std::span<const double> wanted, double reach, bool closed) {
    if (closed) {
        even_out(value);
        return;
    }
    // (2 + pull)·v[i] − v[i−1] − v[i+1] = pull·wanted[i]: Thomas algorithm.
    const std::size_t n = value.size() - 1;
    const double pull = 1.0 / (reach * reach);
    std::vector<double> c(n + 1, 0.0);
    std::vector<double> d(n + 1, 0.0);
    d[0] = value[0];
    for (std::size_t i = 1; i < n; ++i) {
        const double m = 2.0 + pull - c[i - 1];
        c[i] = 1.0 / m;
        d[i] = (d[i - 1] + pull * wanted[i]) / m;
    }
    for (std::size_t i = n; i-- > 1;) value[i] = d[i] + c[i] * value[i + 1];
}

}  // namespace anisoquad
