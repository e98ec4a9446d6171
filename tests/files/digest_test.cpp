// The SHA-256 of points against values that Python's hashlib gave for struct.pack("<...d").
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "files/point_files.h"

namespace lacuna::files {
namespace {

TEST(Digest, GivenNoPointsThenItIsTheDigestOfNoBytes) {
    EXPECT_EQ(sha256_of({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Digest, GivenPointsThenItIsTheDigestOfTheirLittleEndianDoubles) {
    const std::vector<Point> one = {{0.5, 0.25}};
    EXPECT_EQ(sha256_of(one), "9543aca8e8dc3f8c377f3329b9e43f07798a2f6afd07c6c238976f2c78be0513");
    const std::vector<Point> two = {{0.1, 0.2}, {-0.0, 1e300}};
    EXPECT_EQ(sha256_of(two), "3157719e545f339ff16e254c3c2c973e8ea4ce73b117661f6cc837e33cf9a386");
}

TEST(Digest, GivenMorePointsThanOneUpdateTakesThenNoneIsLeftOut) {
    std::vector<Point> points(10000);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = static_cast<double>(i) / 16384;
        points[i] = {x, 1 - x};
    }
    EXPECT_EQ(sha256_of(points),
              "1e5530bca5319f25d5b90baeed97afce913f5c3f52e98892d09860564b1d7c6c");
}

TEST(Digest, GivenAnotherOrderThenItDiffers) {
    const std::vector<Point> points = {{0.5, 0.25}, {0.25, 0.5}};
    const std::vector<Point> swapped = {{0.25, 0.5}, {0.5, 0.25}};
    EXPECT_NE(sha256_of(points), sha256_of(swapped));
}

}  // namespace
}  // namespace lacuna::files
