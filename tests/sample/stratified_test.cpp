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
#include "lattice/curve.h"

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

// Calls look(curve, grid) for grids of many shapes, in boxes and on tori.
template <typename Look>
void for_each_grid(std::uint32_t cut, const Look& look) {
    for (const bool wraps : {false, true})
        for (std::uint32_t columns = 1; columns <= 40; columns += columns < 8 ? 1 : 5)
            for (std::uint32_t rows = 1; rows <= 40; rows += rows < 8 ? 1 : 5) {
                const PixelGrid grid{columns, rows, cut, cut + 2, wraps};
                look(RandomCurve(grid, std::uint64_t{columns} * rows, 1), grid);
            }
}

TEST(ACurve, VisitsEveryPixelOnceAndGoesFromNeighbourToNeighbourInTheGrid) {
    for_each_grid(1, [](const RandomCurve&, PixelGrid grid) {
        grid.cut_y = 1;
        std::vector<int> visits(std::size_t{grid.columns} * grid.rows);
        std::vector<InPixel> parts;
        RandomCurve(grid, grid.columns, 1).follow([&](const InPixel& part) {
            ++visits.at(part.pixel);
            parts.push_back(part);
        });
        ASSERT_EQ(std::count(visits.begin(), visits.end(), 1),
                  static_cast<std::ptrdiff_t>(visits.size()))
            << grid.columns << " x " << grid.rows;
        std::size_t jumps = 0;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const auto apart = [](std::uint64_t a, std::uint64_t b, std::uint64_t cells) {
                const std::uint64_t way = a < b ? b - a : a - b;
                return std::min(way, cells - way);
            };
            jumps += apart(parts[i].x, parts[i - 1].x, grid.columns) +
                         apart(parts[i].y, parts[i - 1].y, grid.rows) >
                     1;
        }
        EXPECT_LE(jumps, grid.columns + grid.rows) << grid.columns << " x " << grid.rows;
    });
}

TEST(ACurve, PassesAllCellsOfAPixelInSquares) {
    for_each_grid(5, [](const RandomCurve& curve, const PixelGrid& grid) {
        std::vector<std::uint64_t> cells(std::size_t{grid.columns} * grid.rows);
        curve.follow([&](const InPixel& part) {
            cells.at(part.pixel) += part.cells();
            ASSERT_EQ(part.x / grid.cut_x + part.y / grid.cut_y * grid.columns, part.pixel);
        });
        for (const std::uint64_t one : cells) ASSERT_EQ(one, grid.cut_x * grid.cut_y);
    });
}

TEST(ACurve, GoesThroughASquareFromOneCornerToTheNext) {
    const InSquare first = at_rank(0), last = at_rank(~0U);
    EXPECT_EQ(first.x + first.y + last.y, 0U);
    EXPECT_EQ(last.x, 65535U);
    InSquare before = first;
    for (std::uint32_t rank = 1; rank < 100'000; ++rank) {
        const InSquare at = at_rank(rank);
        ASSERT_EQ(std::abs(static_cast<int>(at.x - before.x)) +
                      std::abs(static_cast<int>(at.y - before.y)),
                  1);
        before = at;
    }
}

// Where a square ends the next one begins, whichever size they have.
TEST(ACurve, EntersEachSquareWhereItLeftTheLast) {
    Point end{0, 0};
    const auto position = [](const Square& square, std::uint32_t rank) {
        const auto [x, y] = square.at(rank);
        return Point{static_cast<double>(square.lowest().x) + x,
                     static_cast<double>(square.lowest().y) + y};
    };
    follow_curve(Square{{0, 0}, {1, 0}, {0, 1}, 64}, [&](const Square& square) {
        if (square.side > 4 || (square.side > 1 && square.corner.x > 20)) return true;
        const Point begin = position(square, 0);
        EXPECT_LE(std::hypot(begin.x - end.x, begin.y - end.y), 8 / 65536.0);
        end = position(square, ~0U);
        return false;
    });
    EXPECT_NEAR(end.x, 64, 8 / 65536.0);
}

// A square cuts intervals of the curve, about in proportion to the root of its share. With points
// at random the mean square deviation is the share, which is at least 2.6 times its root.
TEST(AStratifiedStart, GivesEverySquareOfAnEmptyDomainItsShare) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus})
        for (const std::uint64_t count : {1000u, 4096u, 5000u}) {
            double squared = 0;
            constexpr std::uint64_t kSeeds = 5;
            for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
                std::vector<int> squares(12 * 12);
                Request request = stratified(count, seed);
                request.domain.boundary = boundary;
                for (const Point& point : sample(request).points)
                    ++squares.at(static_cast<std::size_t>(point.y * 12) * 12 +
                                 static_cast<std::size_t>(point.x * 12));
                const double share = static_cast<double>(count) / 144;
                for (const int square : squares) squared += std::pow(square - share, 2);
            }
            EXPECT_LT(squared / (kSeeds * 144), 0.7 * std::sqrt(static_cast<double>(count) / 144))
                << count;
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
    for (const int square : squares) EXPECT_NEAR(square, 10, 3);
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
            EXPECT_NEAR(counts[i], fair, std::max(3.0, 0.05 * fair)) << shapes.areas[i];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AStratifiedStart, FairShares, testing::Values(500, 2000, 20'000));

}  // namespace lacuna::tests
