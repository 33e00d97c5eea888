#include "parts/in_parts.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <vector>

#include "parts/division.h"
#include "parts/tasks.h"

namespace anisoquad {

void in_parts(SurfaceMesh& mesh, const Partition& partition, Context& context,
              const std::function<void(SurfaceMesh&, const Cuts&, Context&)>& work) {
    if (partition.parts <= 1) {
        work(mesh, {}, context);
        return;
    }
    std::vector<Part> parts(static_cast<std::size_t>(partition.parts));
    std::vector<std::int32_t> weights;
    const std::int32_t vertex_slots = mesh.vertex_slots();
    const std::int32_t edge_slots = mesh.edge_slots();
    {
        Division division(mesh, partition.part_of_face, partition.parts, context);
        for (std::int32_t i = 0; i < partition.parts; ++i) weights.push_back(division.face_count(i));
        const std::int32_t together = tbb::this_task_arena::max_concurrency();
        for (std::int32_t first = 0; first < partition.parts; first += together) {
            context.breathe();
            tbb::parallel_for(first, std::min(partition.parts, first + together),
                              [&](std::int32_t i) { parts[static_cast<std::size_t>(i)] = division.take(i); });
        }
        mesh = {};
    }
    context.breathe();
    run_tasks(weights, context, [&](std::int32_t task, Context& own) {
        const auto i = static_cast<std::size_t>(task);
        work(parts[i].mesh, partition.cuts[i], own);
    });
    mesh = join(parts, vertex_slots, edge_slots, context);
}

}  // namespace anisoquad
