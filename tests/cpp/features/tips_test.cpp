#include "features/tips.h"

#include <gtest/gtest.h>

#include "stages.h"

namespace anisoquad {
namespace {

std::vector<Tip> tips_of(const shapes::Shape& shape) { return find_tips(stages::Prepared(shape).mesh); }

TEST(FindTips, TheTopOfACone) {
    const shapes::Shape cone = shapes::cone(24, 8, 1.5);
    const std::vector<Tip> tips = tips_of(cone);
    ASSERT_EQ(tips.size(), 1u);
    EXPECT_EQ(tips[0].place, Point(0.0, 0.0, 1.5));
    EXPECT_EQ(tips[0].input, static_cast<std::int32_t>(cone.points.size()) - 1);
    EXPECT_EQ(tips[0].patch, 0);
}

TEST(FindTips, NoneWhereTheSurfaceIsNearlyFlat) { EXPECT_TRUE(tips_of(shapes::cone(24, 8, 0.2)).empty()); }

TEST(FindTips, NoneWhereTheWholeSurfaceTurnsLikeThat) { EXPECT_TRUE(tips_of(shapes::sphere(12, 8)).empty()); }

TEST(FindTips, NoneOnLines) { EXPECT_TRUE(tips_of(shapes::cube(4)).empty()); }

}  // namespace
}  // namespace anisoquad
