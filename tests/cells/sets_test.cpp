// Whole sets of mode cells keep their promises: distances by the metric, no lattice point left,
// none where importance is 0.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fields.h"
#include "judge/cells.h"

namespace {

using namespace lacuna;
using judge::CellsJudge;

Request cells_request(const Field& field, double scale, Metric metric, Boundary boundary) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale = scale;
    request.metric = metric;
    request.domain.boundary = boundary;
    request.paper2011.lines_per_radius = 10;
    return request;
}

void expect_all_promises(const Request& request) {
    const Result result = sample(request);
    EXPECT_TRUE(result.maximal);
    const CellsJudge judge(request, result.points);
    EXPECT_EQ(judge.fault(), "");
    EXPECT_EQ(judge.room(), "");
}

// The other tests rely on the judge. This test shows that it notices faults.
TEST(CellsSets, TheJudgeSeesOnePointMissingOrMoved) {
    const Field field = tests::noise_field(12, 9, 3);
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max})
        for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
            const Request request =
                cells_request(field, tests::scale_of(field, 1, 25), metric, boundary);
            const std::vector<Point> points = sample(request).points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                std::vector<Point> others = points;
                others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
                EXPECT_NE(CellsJudge(request, others).room(), "") << i;
                others = points;
                others.push_back(points[i]);
                EXPECT_NE(CellsJudge(request, others).fault(), "");
                others = points;
                others[i].x += 1e-6;
                EXPECT_NE(CellsJudge(request, others).fault(), "");
            }
        }
}

// Random small fields are judged by hostile.
TEST(CellsSets, KeepEveryPromise) {
    struct Row {
        Field field;
        double count, width = 1, height = 1;
        std::uint64_t seeds = 1;
    };
    std::vector<Row> rows{{tests::noise_field(300, 200, 5), 2000},
                          {tests::white_holes_field(200, 200), 4000},
                          {tests::one_dark_pixel_field(64, 64), 100},
                          {tests::ramp_field(1, 80), 50},
                          {tests::noise_field(1, 80, 1), 50},
                          {tests::noise_field(80, 1, 2), 50},
                          {tests::constant_field(1, 1), 50},
                          {tests::noise_field(400, 300, 3), 50},
                          // The mean of a small radius and one far larger than the domain is still
                          // larger than the domain.
                          {tests::step_field(10, 10, 1e8), 35, 1, 1, 20}};
#ifdef LACUNA_RACCOON
    rows.push_back({tests::raccoon_field(512), 20'000, 4, 3});
#endif
    for (const Row& row : rows)
        for (const Metric metric : {Metric::min, Metric::mean, Metric::max})
            for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
                SCOPED_TRACE(std::to_string(row.field.columns) + "x" +
                             std::to_string(row.field.rows) + ", " + std::string(name_of(metric)));
                const double scale = tests::scale_of(row.field, row.width * row.height, row.count);
                Request request = cells_request(row.field, scale, metric, boundary);
                request.domain.width = row.width;
                request.domain.height = row.height;
                for (request.seed = 0; request.seed < row.seeds; ++request.seed)
                    expect_all_promises(request);
            }
}

// A row that is lower than a few of the steps that m asks for. At 16 and 12 it is 0.6 and 0.8 of
// such a step high, at 6 and 4 it is 1.7 and 2.5.
TEST(CellsSets, ARowOfPixelsIsFilledToItsEnds) {
    const Field field = tests::constant_field(1000, 1);
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.domain.width = 1000;
    request.paper2011.lines_per_radius = 10;
    for (const double radius : {125.0, 16.0, 12.0, 6.0, 4.0}) {
        request.scale = radius;
        for (request.seed = 0; request.seed < 20; ++request.seed) {
            std::vector<double> places;
            for (const Point point : sample(request).points) places.push_back(point.x);
            std::sort(places.begin(), places.end());
            ASSERT_FALSE(places.empty());
            const double step = std::min(1.0, radius / 10);  // no longer than the row is high
            EXPECT_LE(places.front(), radius + step) << radius;
            EXPECT_GE(places.back(), 1000 - radius - step) << radius;
            for (std::size_t i = 1; i < places.size(); ++i)
                EXPECT_LE(places[i] - places[i - 1], 2 * (radius + step)) << radius;
            EXPECT_EQ(CellsJudge(request, sample(request).points).fault(), "") << radius;
        }
    }
}

TEST(CellsSets, TheLatticeHasCeilMOverTheLeastRadiusColumns) {
    const Field field = tests::constant_field(1, 1, 4);
    Request request = cells_request(field, 0.0666, Metric::min, Boundary::torus);
    request.domain.width = 2;
    request.paper2011.lines_per_radius = 7;
    const Result result = sample(request);
    EXPECT_EQ(result.radius, 0.0333);
    EXPECT_EQ(result.scale, 0.0666);
    const CellsJudge judge(request, result.points);
    EXPECT_EQ(judge.columns(), 421);  // 7 * 2 / 0.0333 = 420.4
    EXPECT_EQ(judge.rows(), 211);     // 210.5
    EXPECT_EQ(judge.fault(), "");
}

}  // namespace
