// Mode stratified: every part of the domain has its share of the points, on every shape of
// picture, and the same points everywhere.
#include <gtest/gtest.h>

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "fields.h"
#include "refusal.h"
#include "sampling/curve.h"

namespace lacuna::tests {

Request stratified(std::uint64_t count, std::uint64_t seed = 0) {
    Request request;
    request.mode = Mode::stratified;
    request.count = count;
    request.seed = seed;
    return request;
}

// Over a field whose pixels are squares.
Request stratified(std::uint64_t count, const Field& field) {
    Request request = stratified(count);
    request.field = &field;
    const double longer = std::max(field.columns, field.rows);
    request.domain.width = field.columns / longer;
    request.domain.height = field.rows / longer;
    return request;
}

TEST(ACurve, VisitsEveryCellOfAGridOnceAndGoesFromNeighbourToNeighbour) {
    for (std::uint32_t columns = 1; columns <= 40; ++columns)
        for (std::uint32_t rows = 1; rows <= 40; ++rows) {
            std::vector<int> visits(std::size_t{columns} * rows);
            std::vector<Cell> cells;
            for_each_on_curve(columns, rows, [&](Cell cell) {
                ++visits.at(static_cast<std::size_t>(cell.y) * columns +
                            static_cast<std::size_t>(cell.x));
                cells.push_back(cell);
            });
            ASSERT_TRUE(std::all_of(visits.begin(), visits.end(), [](int one) { return one == 1; }))
                << columns << " x " << rows;
            int diagonal = 0;
            for (std::size_t i = 1; i < cells.size(); ++i) {
                const auto dx = std::abs(cells[i].x - cells[i - 1].x);
                const auto dy = std::abs(cells[i].y - cells[i - 1].y);
                ASSERT_LE(std::max(dx, dy), 1);
                diagonal += static_cast<int>(dx + dy == 2);
            }
            ASSERT_LE(diagonal, 1) << columns << " x " << rows;
        }
}

TEST(ACurve, GoesThroughACellFromOneCornerToTheNext) {
    const InCell first = at_rank(0), last = at_rank(~0U);
    EXPECT_EQ(first.x + first.y + last.y, 0U);
    EXPECT_EQ(last.x, 65535U);
    InCell before = first;
    for (std::uint32_t rank = 1; rank < 100'000; ++rank) {
        const InCell at = at_rank(rank);
        ASSERT_EQ(std::abs(static_cast<int>(at.x - before.x)) +
                      std::abs(static_cast<int>(at.y - before.y)),
                  1);
        before = at;
    }
}

// Where a cell ends the next one begins: within it and across its sides the curve is unbroken.
TEST(ACurve, EntersEachCellWhereItLeftTheLast) {
    bool at_right = false, at_top = false;
    bool has_last = false;
    double x = 0, y = 0;
    Cell cell{0, 0};
    for_each_on_curve(24, 10, [&](Cell next) {
        if (next.x == 0 && next.y == 0) return;
        const Way way = way_to(at_right, at_top, next.x - cell.x, next.y - cell.y);
        const auto position = [&](std::uint32_t rank) {
            const InCell in = way.at(rank);
            return Point{static_cast<double>(cell.x) + in.x / 65536.0,
                         static_cast<double>(cell.y) + in.y / 65536.0};
        };
        const Point begin = position(0), end = position(~0U);
        if (has_last) {
            EXPECT_LE(std::hypot(begin.x - x, begin.y - y), 2 / 65536.0);
        }
        x = end.x;
        y = end.y;
        has_last = true;
        cell = next;
    });
}

// A square is a stretch of the curve: it has its share to within one, and the half interval in
// which a point may lie.
TEST(AStratifiedStart, GivesEverySquareOfAnEmptyDomainItsShare) {
    for (const std::uint64_t count : {1000u, 4096u, 5000u}) {
        std::vector<int> squares(9 * 64);
        for (const Point& point : sample(stratified(count)).points)
            ++squares.at(static_cast<std::size_t>(point.y * 24) * 24 +
                         static_cast<std::size_t>(point.x * 24));
        const double share = static_cast<double>(count) / 576;
        for (const int square : squares) EXPECT_NEAR(square, share, 1.5) << count;
    }
}

TEST(AStratifiedStart, HasTheCountAskedForOnEveryShapeOfPictureAndNoPointOnWhite) {
    for (const std::uint32_t columns : {1u, 2u, 37u, 300u})
        for (const std::uint32_t rows : {1u, 5u, 64u})
            for (const std::uint64_t count : {1u, 2u, 1000u}) {
                const Field field = lacuna::tests::made_field(
                    columns, rows, [](double x, double) { return x < 0.2 || x > 0.4 ? 0.3 : 0; });
                const Request request = stratified(count, field);
                const std::vector<Point> points = sample(request).points;
                ASSERT_EQ(points.size(), count);
                for (const Point& point : points) {
                    const auto column =
                        static_cast<std::size_t>(point.x / request.domain.width * columns);
                    const auto row =
                        static_cast<std::size_t>(point.y / request.domain.height * rows);
                    ASSERT_GT(field.importance[(rows - 1 - row) * columns + column], 0);
                }
            }
}

// One pixel may hold all points, and pixels may be far from square.
TEST(AStratifiedStart, DividesAWidePixelEvenly) {
    Request request = stratified(1000);
    request.domain.width = 100;
    std::vector<int> squares(100);
    for (const Point& point : sample(request).points)
        ++squares.at(static_cast<std::size_t>(point.x));
    for (const int square : squares) EXPECT_NEAR(square, 10, 1);
}

// Isolated lines and squares of 1 to 40 pixels on white.
struct Shapes {
    Field field{600, 300, std::vector<double>(std::size_t{600} * 300, 0)};
    std::vector<int> shape_of = std::vector<int>(std::size_t{600} * 300, -1);
    std::vector<double> areas;

    Shapes() {
        std::uint32_t row = 10;
        for (const std::uint32_t width : {1u, 2u, 3u, 5u, 8u}) {
            fill(20, row, 160, width);
            row += width + 12;
        }
        std::uint32_t column = 200;
        for (const std::uint32_t side : {1u, 2u, 4u, 8u, 12u, 20u, 28u, 40u}) {
            fill(column, 15, side, side);
            fill(column, 120, side, side);
            column += side + 15;
        }
        fill(30, 190, 8, 90);
        fill(60, 190, 1, 90);
    }
    void fill(std::uint32_t left, std::uint32_t top, std::uint32_t width, std::uint32_t height) {
        for (std::uint32_t y = top; y < top + height; ++y)
            for (std::uint32_t x = left; x < left + width; ++x) {
                field.importance[std::size_t{y} * 600 + x] = 1;
                shape_of[std::size_t{y} * 600 + x] = static_cast<int>(areas.size());
            }
        areas.push_back(double{1} * width * height);
    }
    std::vector<int> counts(const std::vector<Point>& points) const {
        std::vector<int> found(areas.size());
        for (const Point& point : points) {
            const auto x = static_cast<std::size_t>(point.x * 600);
            const auto y = 299 - static_cast<std::size_t>(point.y * 600);
            ++found.at(static_cast<std::size_t>(shape_of[y * 600 + x]));
        }
        return found;
    }
};

class FairShares : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FairShares, AreWhatEveryShapeHasBeforeAndAfterRelaxing) {
    const Shapes shapes;
    const Request request = stratified(GetParam(), shapes.field);
    const std::vector<Point> start = sample(request).points;
    RelaxOptions options;
    options.domain.width = request.domain.width;
    options.domain.height = request.domain.height;
    const double all = std::reduce(shapes.areas.begin(), shapes.areas.end());
    for (const auto& points : {start, relax(start, &shapes.field, options).points}) {
        const std::vector<int> counts = shapes.counts(points);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double fair = static_cast<double>(GetParam()) * shapes.areas[i] / all;
            EXPECT_NEAR(counts[i], fair, std::max(1.5, 0.05 * fair)) << shapes.areas[i];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AStratifiedStart, FairShares, testing::Values(500, 2000, 20'000));

TEST(AStratifiedStart, IsTheSameEverywhereAndDependsOnTheSeed) {
    const std::vector<Point> points = sample(stratified(1000, 7)).points;
    EXPECT_EQ(points, sample(stratified(1000, 7)).points);
    EXPECT_NE(points, sample(stratified(1000, 8)).points);
}

TEST(AStratifiedStart, RefusesWhatItHasNoUseFor) {
    const auto refusal = [](const std::function<void(Request&)>& change) {
        Request request = stratified(10);
        change(request);
        return refusal_of([&] { sample(request); });
    };
    const std::string takes_a_count = ": is not for mode stratified, which takes a count";
    EXPECT_EQ(refusal([](Request& r) { r.radius = 0.5; }), "radius 0.5" + takes_a_count);
    EXPECT_EQ(refusal([](Request& r) { r.limit = 3; }), "limit 3" + takes_a_count);
    EXPECT_EQ(refusal([](Request& r) { r.paper2011.lines_per_radius = 3; }),
              "lines-per-radius 3" + takes_a_count);
    EXPECT_EQ(refusal([](Request& r) { r.paper2011.round_size = 1; }),
              "round-size 1" + takes_a_count);
    EXPECT_EQ(refusal([](Request& r) { r.metric = Metric::max; }), "metric max" + takes_a_count);
    EXPECT_EQ(refusal([](Request& r) { r.count.reset(); }),
              "count missing: mode stratified needs one");
    EXPECT_EQ(refusal([](Request& r) { r.count = 0; }), "count 0: must be at least 1");
    EXPECT_EQ(refusal([](Request& r) { r.border = 0.1; }),
              "border with mode stratified: is for mode exact only");
}

}  // namespace lacuna::tests
