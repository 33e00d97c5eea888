#include "picking/zigzag.h"

#include <gtest/gtest.h>

#include "picking/best_path.h"
#include "picking/picking_shapes.h"

namespace anisoquad {
namespace {

TEST(Zigzag, APathOverAnUnstructuredTriangulation) {
    const PickSurface surface = shapes::pick_surface(shapes::unstructured(20));
    EXPECT_TRUE(is_zigzag(surface.mesh, shapes::vertices(best_path(surface, 10 * 21 + 1, 13 * 21 + 19))));
}

TEST(Zigzag, StraightLinesAndSmoothBendsAreNone) {
    const PickSurface grid = shapes::pick_surface(shapes::grid(12, 10));
    EXPECT_FALSE(is_zigzag(grid.mesh, shapes::vertices(best_path(grid, 5 * 13 + 2, 5 * 13 + 9))));
    const int n = 30;
    const PickSurface cylinder = shapes::pick_surface(shapes::cylinder(n, 6));
    std::vector<std::int32_t> ring;
    for (int i = 0; i <= n; ++i) ring.push_back(3 * n + i % n);
    EXPECT_FALSE(is_zigzag(cylinder.mesh, shapes::vertices(ring))) << "bent in space, straight on the surface";
}

TEST(Zigzag, ACornerIsNoneAndTwoFarApartNeither) {
    const PickSurface grid = shapes::pick_surface(shapes::grid(12, 10));
    std::vector<std::int32_t> stairs;
    for (int i = 1; i <= 5; ++i) stairs.push_back(13 + i);
    for (int j = 2; j <= 7; ++j) stairs.push_back(13 * j + 5);
    EXPECT_FALSE(is_zigzag(grid.mesh, shapes::vertices(stairs)));
    for (int i = 6; i <= 10; ++i) stairs.push_back(13 * 7 + i);
    EXPECT_FALSE(is_zigzag(grid.mesh, shapes::vertices(stairs)));
}

}  // namespace
}  // namespace anisoquad
