// The whole way of the data, on the wings of tests/data. Compare two builds with
// `anisoquad_benchmark --benchmark_format=json`.
#include "quad_mesh.h"

#include <benchmark/benchmark.h>

#include <fstream>
#include <limits>
#include <string>

namespace anisoquad {
namespace {

struct Surface {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> leading_edge;
};

Surface read_wing(const std::string& name) {
    const std::string path = ANISOQUAD_TEST_DATA "/" + name;
    Surface surface;
    std::ifstream off(path + ".off");
    std::string magic;
    std::size_t points = 0;
    std::size_t triangles = 0;
    int count = 0;
    off >> magic >> points >> triangles >> count;
    surface.points.resize(points);
    for (auto& p : surface.points) off >> p.x() >> p.y() >> p.z();
    surface.triangles.resize(triangles);
    for (auto& t : surface.triangles) off >> count >> t[0] >> t[1] >> t[2];
    std::ifstream json(path + ".json");
    json.ignore(std::numeric_limits<std::streamsize>::max(), '[');
    char separator = ',';
    for (std::int32_t id = 0; separator == ',' && json >> id >> separator;) surface.leading_edge.push_back(id);
    return surface;
}

void mesh_wing(benchmark::State& state, const std::string& name) {
    const Surface surface = read_wing(name);
    const Source source{surface.leading_edge, passes_for_anisotropy(static_cast<int>(state.range(0))), Sides::both};
    for (auto _ : state) {
        try {
            const QuadMeshResult result = quad_mesh(surface.points, surface.triangles, {&source, 1});
            state.counters["quads"] = result.report.quads;
            state.counters["sj_min"] = result.report.scaled_jacobian.min;
        } catch (const Error& error) {
            state.SkipWithError(error.what());
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(surface.triangles.size()));
}

BENCHMARK_CAPTURE(mesh_wing, delta, std::string("wing_delta"))->Arg(1)->Arg(4)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesh_wing, swept, std::string("wing_swept"))->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace anisoquad
