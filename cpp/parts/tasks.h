#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "context.h"

namespace anisoquad {

/// Runs tasks side by side, the heaviest first. The context is only asked by the calling thread, also while it waits for the
/// others, and shares out what is done by the weights.
/// @param task (number of the task, its own context); the tasks must not touch what belongs to another one
/// @throws Error{cancelled}; what the task with the lowest number threw
void run_tasks(std::span<const std::int32_t> weights, const Context& context,
               const std::function<void(std::int32_t, Context&)>& task);

}  // namespace anisoquad
