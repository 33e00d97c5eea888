// The whole way of the data and each of its stages, at 10 thousand, 100 thousand and a million triangles. The counters are the
// stages' seconds; compare two builds with tests/benchmark/compare_builds.py.
#include "quad_mesh.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "surfaces.h"

namespace anisoquad {
namespace {

double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void mesh(benchmark::State& state, const benchmarks::Surface& surface, std::span<const Source> sources) {
    const double before = peak_memory();
    for (auto _ : state) {
        const QuadMeshResult result = quad_mesh(surface.points, surface.triangles, sources);
        state.counters["quads"] = result.report.quads;
        state.counters["sj_min"] = result.report.scaled_jacobian.min;
        for (const StageTime& stage : result.report.times) state.counters[stage.stage] = stage.seconds;
    }
    // Of the process: only the first, or the largest, of a run tells its own.
    state.counters["grown_by_MB"] = peak_memory() - before;
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(surface.triangles.size()));
    state.SetComplexityN(static_cast<std::int64_t>(surface.triangles.size()));
}

void mesh_plane(benchmark::State& state) { mesh(state, benchmarks::plane(static_cast<int>(state.range(0))), {}); }
void mesh_sphere(benchmark::State& state) { mesh(state, benchmarks::sphere(static_cast<int>(state.range(0))), {}); }

void mesh_wing(benchmark::State& state, const std::string& name) {
    const benchmarks::Surface surface = benchmarks::wing(name, static_cast<int>(state.range(0)));
    const auto ratio = static_cast<int>(state.range(1));
    const Source source{surface.leading_edge, passes_for_anisotropy(ratio), Sides::both};
    mesh(state, surface, ratio > 1 ? std::span(&source, 1) : std::span<const Source>());
}

BENCHMARK(mesh_plane)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(mesh_sphere)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK_CAPTURE(mesh_wing, delta, std::string("wing_delta"))
    ->ArgsProduct({{8000, 100000, 500000}, {1}})
    ->Args({8000, 4})
    ->Args({8000, 16})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesh_wing, swept, std::string("wing_swept"))
    ->ArgsProduct({{8000, 100000, 500000}, {1}})
    ->Args({8000, 16})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace anisoquad
