#include "anisotropy/split_stack.h"

#include <algorithm>

namespace anisoquad {
namespace {

constexpr double kSlot = 4.0;  ///< least width of what stays behind over the height of the uppermost row

/// The columns from `first` to `last`, counted on past the end of a closed stack.
RowStack part_of(const RowStack& stack, std::size_t first, std::size_t last, bool is_running) {
    RowStack part;
    part.source = stack.source;
    part.left = stack.left;
    part.pass_of_row = stack.pass_of_row;
    part.rows_before = stack.rows_before;
    part.is_running = is_running;
    if (!is_running) part.stopped = stack.stopped;
    for (const std::vector<Vertex>& layer : stack.layers) {
        part.layers.emplace_back();
        for (std::size_t i = first; i <= last; ++i)
            part.layers.back().push_back(layer[i <= stack.columns() ? i : i - stack.columns()]);
    }
    return part;
}

/// Lets what stays grow to both sides until it is wide enough for the height of the rows beside it.
void widen(const SurfaceMesh& mesh, const RowStack& stack, std::size_t start, std::vector<char>& stays) {
    const std::size_t n = stays.size();
    std::vector<double> width;
    std::vector<double> height;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t c = (start + i) % n;
        width.push_back((mesh.position(stack.top()[c + 1]) - mesh.position(stack.top()[c])).norm());
        height.push_back(stack.rows() > 0 ? stack.height(mesh, c) : width.back());
    }
    const std::vector<char> misfit = stays;
    for (std::size_t i = 0; i < n; ++i) {
        if (!misfit[i] || (i > 0 && misfit[i - 1])) continue;
        std::size_t first = i;
        std::size_t last = i;
        double sum = width[i];
        for (; last + 1 < n && misfit[last + 1]; ++last) sum += width[last + 1];
        while (sum < kSlot * height[i] && (first > 0 || last + 1 < n)) {
            if (first > 0) sum += width[--first];
            if (last + 1 < n) sum += width[++last];
        }
        std::fill(stays.begin() + static_cast<std::ptrdiff_t>(first), stays.begin() + static_cast<std::ptrdiff_t>(last) + 1, 1);
    }
}

bool fit_together(const RowStack& a, const RowStack& b) {
    if (!a.goes_on || a.pass_of_row != b.pass_of_row) return false;
    for (std::size_t j = 0; j < a.layers.size(); ++j) {
        if (a.layers[j].back() != b.layers[j].front()) return false;
    }
    return true;
}

}  // namespace

std::vector<RowStack> split_stack(const SurfaceMesh& mesh, const RowStack& stack, std::size_t least) {
    const std::size_t n = stack.columns();
    if (stack.misfit.size() != n || std::find(stack.misfit.begin(), stack.misfit.end(), 1) == stack.misfit.end()) return {};
    // A closed stack is opened where a run of columns that do not fit begins.
    std::size_t start = 0;
    if (stack.closed) {
        while (!stack.misfit[start] || stack.misfit[start > 0 ? start - 1 : n - 1]) {
            if (++start == n) return {};
        }
    }
    std::vector<char> stays;
    for (std::size_t i = 0; i < n; ++i) stays.push_back(stack.misfit[(start + i) % n]);
    widen(mesh, stack, start, stays);
    for (std::size_t i = 0; i < n;) {
        std::size_t end = i;
        while (end < n && !stays[end]) ++end;
        if (end - i < least)
            std::fill(stays.begin() + static_cast<std::ptrdiff_t>(i), stays.begin() + static_cast<std::ptrdiff_t>(end), 1);
        i = end + 1;
    }
    if (std::find(stays.begin(), stays.end(), 0) == stays.end()) return {};
    std::vector<RowStack> parts;
    for (std::size_t i = 0; i < n;) {
        std::size_t end = i;
        while (end < n && stays[end] == stays[i]) ++end;
        parts.push_back(part_of(stack, start + i, start + end, !stays[i]));
        parts.back().goes_on = end < n || stack.goes_on;
        i = end;
    }
    return parts;
}

std::vector<RowStack> join_stacks(std::vector<RowStack> stacks) {
    std::vector<RowStack> joined;
    for (RowStack& stack : stacks) {
        if (joined.empty() || !fit_together(joined.back(), stack)) {
            joined.push_back(std::move(stack));
            continue;
        }
        RowStack& before = joined.back();
        before.goes_on = stack.goes_on;
        for (std::size_t j = 0; j < stack.layers.size(); ++j) {
            before.layers[j].insert(before.layers[j].end(), stack.layers[j].begin() + 1, stack.layers[j].end());
        }
    }
    return joined;
}

}  // namespace anisoquad
