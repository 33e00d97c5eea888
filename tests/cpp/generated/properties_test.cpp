#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "generated/run_case.h"
#include "generated/surfaces.h"
#include "input/check.h"

/// What must hold for the mesh of any valid surface, over hundreds of generated ones; over thousands with ANISOQUAD_CASES, the
/// number of cases a shard.
namespace anisoquad::generated {
namespace {

#ifdef ANISOQUAD_VALIDATE
constexpr unsigned kCases = 8;  // a shard: builds with assertions are slow
#else
constexpr unsigned kCases = 80;
#endif
constexpr int kShards = 10;
constexpr unsigned kEnoughForAShare = 30;
constexpr double kMostSeconds = 30.0;  // of processor time for one surface of some hundred triangles: far beyond what any needs

unsigned cases() {
    const char* asked = std::getenv("ANISOQUAD_CASES");
    return asked ? static_cast<unsigned>(std::atoi(asked)) : kCases;
}

std::vector<std::uint8_t> random_bytes(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(160);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    return bytes;
}

class Generated : public testing::TestWithParam<int> {
  protected:
    template <class Function>
    void for_cases(Function f) const {
        for (unsigned i = 0; i < cases(); ++i) {
            const unsigned seed = static_cast<unsigned>(GetParam()) * 10000 + i;
            SCOPED_TRACE("seed " + std::to_string(seed));
            f(random_bytes(seed));
        }
    }
};

TEST_P(Generated, SurfacesAreValid) {
    for_cases([](const std::vector<std::uint8_t>& bytes) {
        ByteSource source(bytes);
        const shapes::Shape shape = make_surface(source, 1.0);
        if (shape.triangles.empty()) return;
        EXPECT_NO_THROW(check_input(shape.points, shape.triangles));
    });
}

TEST_P(Generated, ValidSurfacesGiveValidMeshesOfQuadsOnly) {
    std::int64_t quads = 0;
    std::int64_t inverted = 0;
    for_cases([&](const std::vector<std::uint8_t>& bytes) {
        ByteSource source(bytes);
        const MeshCase mesh_case = make_case(source, false);
        if (mesh_case.shape.triangles.empty()) return;
        ASSERT_TRUE(mesh_case.is_valid);
        const std::clock_t start = std::clock();
        const Outcome outcome = run_case(mesh_case);
        EXPECT_EQ(outcome.failure, "");
        EXPECT_TRUE(outcome.meshed);
        EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kMostSeconds);
        quads += outcome.quads;
        inverted += outcome.inverted;
    });
    // Folds, needles and lines that meet at no angle leave no room for good quads everywhere.
    // A share says something over many surfaces only: one fold among three is no defect.
    if (cases() >= kEnoughForAShare) {
        EXPECT_LT(static_cast<double>(inverted), 0.06 * static_cast<double>(quads));
    }
}

TEST_P(Generated, WhateverComesInAnErrorOrAValidMeshComesOut) {
    for_cases([](const std::vector<std::uint8_t>& bytes) {
        ByteSource source(bytes);
        EXPECT_EQ(run_case(make_case(source, true)).failure, "");
    });
}

TEST_P(Generated, TheSameInputGivesTheSameBytes) {
    for (unsigned i = 0; i < cases() / 10 + 1; ++i) {
        const std::vector<std::uint8_t> bytes = random_bytes(static_cast<unsigned>(GetParam()) * 10000 + 5000 + i);
        ByteSource source(bytes);
        const MeshCase c = make_case(source, false);
        if (c.shape.triangles.empty()) continue;
        const auto mesh = [&] { return quad_mesh(c.shape.points, c.shape.triangles, c.sources, c.options); };
        const QuadMeshResult first = mesh();
        const QuadMeshResult second = mesh();
        EXPECT_EQ(first.points, second.points);
        EXPECT_EQ(first.quads, second.quads);
        EXPECT_EQ(first.line_edges, second.line_edges);
        EXPECT_EQ(first.row, second.row);
    }
}

TEST(Corpus, CasesThatOnceFailedHold) {
    int files = 0;
    for (const auto& file : std::filesystem::directory_iterator(ANISOQUAD_FUZZ_DATA)) {
        SCOPED_TRACE(file.path().filename().string());
        std::ifstream stream(file.path(), std::ios::binary);
        const std::vector<char> chars((std::istreambuf_iterator<char>(stream)), {});
        const std::vector<std::uint8_t> bytes(chars.begin(), chars.end());
        ByteSource source(bytes);
        EXPECT_EQ(run_case(make_case(source, true)).failure, "");
        ++files;
    }
    EXPECT_GT(files, 0);
}

INSTANTIATE_TEST_SUITE_P(Shards, Generated, testing::Range(0, kShards));

}  // namespace
}  // namespace anisoquad::generated
