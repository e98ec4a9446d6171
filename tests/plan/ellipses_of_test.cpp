// The ellipses of points, as programs that draw them need them.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <vector>

namespace lacuna {
namespace {

TEST(EllipsesOf, AreThoseOfThePixels) {
    // A pixel at the left, and one at the right where no sample may lie.
    const Field field{2, 1, {4, 0}, {{9, 0.5}, {1, 0}}};
    const std::vector<Point> points{{0.1, 0.9}, {1, 0.2}};  // the second one is on the border
    const std::vector<Ellipse> ellipses = ellipses_of(points, field, 0.2, {2, 1});
    ASSERT_EQ(ellipses.size(), 2U);
    for (const Ellipse& ellipse : ellipses) {
        EXPECT_DOUBLE_EQ(ellipse.a, 0.3);
        EXPECT_DOUBLE_EQ(ellipse.b, 0.1 / 3);
        EXPECT_EQ(ellipse.angle, 0.5);
    }
}

TEST(EllipsesOf, AreNoneOnAFieldOfDisks) {
    const std::vector<Point> points{{0.5, 0.5}};
    EXPECT_TRUE(ellipses_of(points, {1, 1, {1}}, 1, {1, 1}).empty());
}

}  // namespace
}  // namespace lacuna
