// Fields whose greatest importance is up to 1e9 times the least: every part has its share.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <vector>

namespace lacuna::tests {
namespace {

// Quarters of importance 4, 3, 2 and 1, and in the first one a square of `greatest`.
struct Range {
    double greatest;
    std::uint32_t pixels;  // along a side of the field
    std::uint32_t bright;  // along a side of the square
    std::uint64_t count;
    Mode mode = Mode::stratified;
    std::uint32_t iterations = 0;
};
void PrintTo(const Range& range, std::ostream* out) {
    *out << range.greatest << " to 1, mode " << static_cast<int>(range.mode) << ", relaxed "
         << range.iterations << " times";
}

class Ranges : public testing::TestWithParam<Range> {
protected:
    // The number of a point's part: of a quarter, or 4 in the square.
    static std::size_t part_of(double x, double y) {
        const Range& range = GetParam();
        const double square = double{1} * range.bright / range.pixels;
        if (x >= 0.25 && x < 0.25 + square && y >= 0.25 && y < 0.25 + square) return 4;
        return std::size_t{x < 0.5 ? 0U : 1U} + (y < 0.5 ? 0U : 2U);
    }
};

TEST_P(Ranges, GiveEachPartItsShare) {
    const Range& range = GetParam();
    const std::array<double, 5> importance{4, 3, 2, 1, range.greatest};
    Field field{range.pixels, range.pixels, {}};
    std::array<double, 5> fair{};
    for (std::uint32_t row = 0; row < range.pixels; ++row)
        for (std::uint32_t column = 0; column < range.pixels; ++column) {
            const std::size_t part =
                part_of((column + 0.5) / range.pixels, 1 - (row + 0.5) / range.pixels);
            field.importance.push_back(importance.at(part));
            fair.at(part) += importance.at(part);
        }
    Request request;
    request.mode = range.mode;
    request.field = &field;
    request.count = range.count;
    const auto of_square = static_cast<double>(range.bright * range.bright);
    double of_others = static_cast<double>(range.count);
    if (range.mode == Mode::pixels) {  // the pixels of the square are full
        request.on_pixels = Raster{range.pixels, range.pixels};
        of_others -= of_square;
        fair[4] = 0;
    }
    const double all = std::accumulate(fair.begin(), fair.end(), 0.0);
    for (double& one : fair) one *= of_others / all;
    if (range.mode == Mode::pixels) fair[4] = of_square;

    std::vector<Point> points = sample(request).points;
    RelaxOptions options;
    options.iterations = range.iterations;
    if (range.iterations != 0) points = relax(points, &field, options).points;
    std::array<double, 5> got{};
    for (const Point& point : points) ++got.at(part_of(point.x, point.y));
    for (std::size_t part = 0; part < got.size(); ++part)
        EXPECT_NEAR(got.at(part), fair.at(part), 0.02 * fair.at(part) + 6) << "part " << part;
}

INSTANTIATE_TEST_SUITE_P(Of, Ranges,
                         testing::Values(Range{1e3, 128, 8, 5000}, Range{1e6, 256, 1, 60'000},
                                         Range{1e9, 1024, 1, 300'000},
                                         Range{1e3, 128, 8, 5000, Mode::stratified, 15},
                                         Range{1e6, 256, 1, 60'000, Mode::stratified, 5},
                                         Range{1e3, 128, 8, 2000, Mode::pixels},
                                         Range{1e6, 128, 8, 2000, Mode::pixels},
                                         Range{1e9, 128, 8, 2000, Mode::pixels}));

TEST(ARange, MayBeAsWideAsThoseOfNumbers) {
    const Field field{4, 1, {1e308, 5e-324, 1e308, 0}};
    Request request;
    request.domain = {4, 1};
    request.mode = Mode::stratified;
    request.field = &field;
    request.count = 1000;
    std::array<int, 4> got{};
    for (const Point& point : sample(request).points) ++got.at(static_cast<std::size_t>(point.x));
    EXPECT_NEAR(got[0], 500, 1);
    EXPECT_NEAR(got[2], 500, 1);
    EXPECT_EQ(got[3], 0);
}

}  // namespace
}  // namespace lacuna::tests
