#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

#include "context.h"

/// Parallel loops over blocks of fixed size, so that results are the same, to the last bit, for any number of threads.
namespace anisoquad {

constexpr std::int32_t kBlock = 4096;

/// Calls f(first, last) for the blocks of [0, n). Calls run side by side: none may write where another one reads or writes.
template <class Function>
void for_blocks(std::int32_t n, Function f) {
    const std::int32_t blocks = (n + kBlock - 1) / kBlock;
    if (blocks == 1) {
        f(0, n);
    } else {
        tbb::parallel_for(std::int32_t{0}, blocks, [&](std::int32_t b) { f(b * kBlock, std::min(n, (b + 1) * kBlock)); });
    }
}

/// Calls f(i) for i in [0, n), in blocks.
template <class Function>
void for_each(std::int32_t n, Function f) {
    for_blocks(n, [&](std::int32_t first, std::int32_t last) {
        for (std::int32_t i = first; i < last; ++i) f(i);
    });
}

/// Calls f(i) for i in [0, n), each call a task of its own; the calling thread asks before each of its tasks whether to go on.
/// @throws Error{cancelled}
template <class Function>
void for_each_task(std::int32_t n, const Context& context, Function f) {
    const std::thread::id caller = std::this_thread::get_id();
    tbb::parallel_for(std::int32_t{0}, n, [&](std::int32_t i) {
        if (std::this_thread::get_id() == caller) context.breathe();
        f(i);
    });
}

/// for_blocks() that asks whether to go on. @throws Error{cancelled}
template <class Function>
void for_blocks(std::int32_t n, const Context& context, Function f) {
    for_each_task((n + kBlock - 1) / kBlock, context, [&](std::int32_t b) { f(b * kBlock, std::min(n, (b + 1) * kBlock)); });
}

template <class Function>
void for_each(std::int32_t n, const Context& context, Function f) {
    for_blocks(n, context, [&](std::int32_t first, std::int32_t last) {
        for (std::int32_t i = first; i < last; ++i) f(i);
    });
}

/// Combines f(first, last) of all blocks in their order, and asks whether to go on.
/// @param combine (so far, of a block) → together
/// @throws Error{cancelled}
template <class Value, class Function, class Combine>
Value reduce_blocks(std::int32_t n, const Context& context, Value start, Function f, Combine combine) {
    std::vector<Value> parts(static_cast<std::size_t>((n + kBlock - 1) / kBlock), start);
    for_blocks(n, context,
               [&](std::int32_t first, std::int32_t last) { parts[static_cast<std::size_t>(first / kBlock)] = f(first, last); });
    for (const Value& part : parts) start = combine(start, part);
    return start;
}

template <class Value, class Function, class Combine>
Value reduce_blocks(std::int32_t n, Value start, Function f, Combine combine) {
    return reduce_blocks(n, no_context(), start, f, combine);
}

/// Calls f with at most that many threads for its loops. @param threads 0: as many as there are cores
template <class Function>
auto with_threads(int threads, Function f) {
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    return arena.execute(f);
}

}  // namespace anisoquad
