// Fields of ellipses that a program gives.
#include <gtest/gtest.h>
#include <lacuna/pictures.h>

#include <numbers>
#include <vector>

#include "refusal.h"

namespace lacuna {
namespace {

TEST(EllipseField, HasTheRadiiAtScaleOneAndTheLongerOneFirst) {
    const std::vector<Ellipse> wanted{{0.4, 0.1, 0.25}, {0.1, 0.4, 0.25}, {0, 0, 7}};
    const Field field = ellipse_field(3, 1, wanted);
    const std::vector<Point> points{{0.5, 0.5}, {1.5, 0.5}};
    const std::vector<Ellipse> found = ellipses_of(points, field, 1, {3, 1});
    for (const Ellipse& ellipse : found) {
        EXPECT_DOUBLE_EQ(ellipse.a, 0.4);
        EXPECT_DOUBLE_EQ(ellipse.b, 0.1);
    }
    EXPECT_EQ(found[0].angle, 0.25);
    EXPECT_DOUBLE_EQ(found[1].angle, 0.25 - std::numbers::pi / 2);
    EXPECT_EQ(field.importance[2], 0);
}

TEST(EllipseField, NamesWhatIsWrong) {
    const auto refused = [](std::uint32_t columns, std::uint32_t rows,
                            const std::vector<Ellipse>& ellipses) {
        return tests::refusal_of([&] { ellipse_field(columns, rows, ellipses); });
    };
    EXPECT_EQ(refused(2, 1, {{1, 1, 0}}),
              "ellipses 1: there must be one for each of 1 x 2 pixels, at least one");
    EXPECT_EQ(refused(1, 2, {{1, 1, 0}, {1, -1, 0}}),
              "ellipses row 1, column 0: radii 1 and -1 at an angle of 0: radii and angle must be "
              "finite, radii over 0, one at most 1000 times the other, or both radii 0");
    EXPECT_EQ(refused(1, 1, {{0, 0, 0}}),
              "ellipses with radii of 0 everywhere: some must be greater");
}

}  // namespace
}  // namespace lacuna
