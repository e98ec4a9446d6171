// Whole sets of mode cells keep their promises: distances by the metric, no lattice point left,
// none where importance is 0.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
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

// Up to 12 x 12 pixels; importance spans three decades, and some pixels are white.
Field random_field() {
    Field field;
    field.columns = *rc::gen::inRange(1u, 13u);
    field.rows = *rc::gen::inRange(1u, 13u);
    const std::uint32_t white_in = *rc::gen::inRange(1u, 9u);
    for (std::uint32_t i = 0; i < field.columns * field.rows; ++i) {
        const bool is_white = *rc::gen::inRange(0u, white_in) == 1;
        field.importance.push_back(is_white ? 0 : std::pow(10, -*rc::gen::inRange(0, 31) / 10.0));
    }
    if (std::all_of(field.importance.begin(), field.importance.end(),
                    [](double value) { return value == 0; }))
        field.importance[0] = 1;
    return field;
}

RC_GTEST_PROP(CellsSets, KeepEveryPromise, ()) {
    const Field field = random_field();
    Request request =
        cells_request(field, 0, *rc::gen::element(Metric::min, Metric::mean, Metric::max),
                      *rc::gen::element(Boundary::box, Boundary::torus));
    request.domain.width = *rc::gen::inRange(50, 301) / 100.0;
    request.domain.height = *rc::gen::inRange(50, 301) / 100.0;
    request.paper2011.lines_per_radius = *rc::gen::inRange(1u, 21u);
    request.scale = tests::scale_of(field, request.domain.width * request.domain.height,
                                    *rc::gen::element(0.5, 5.0, 30.0, 120.0));
    request.paper2011.round_size = *rc::gen::element(0u, 1u, 7u);
    request.seed = *rc::gen::arbitrary<std::uint64_t>();
    request.place.backend = *rc::gen::element<std::string>("cpu", "reference");

    const CellsJudge judge(request, sample(request).points);
    RC_ASSERT(judge.fault() == "");
    RC_ASSERT(judge.room() == "");
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

TEST(CellsSets, KeepEveryPromiseInLargeSets) {
    const Field noise = tests::noise_field(300, 200, 5);
    const Field holes = tests::white_holes_field(200, 200);
    const Field dark = tests::one_dark_pixel_field(64, 64);
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
            SCOPED_TRACE(std::string(name_of(metric)));
            for (const auto& [field, count] :
                 {std::pair(&noise, 2000), {&holes, 4000}, {&dark, 100}})
                expect_all_promises(
                    cells_request(*field, tests::scale_of(*field, 1, count), metric, boundary));
        }
    }
}

#ifdef LACUNA_RACCOON
TEST(CellsSets, KeepEveryPromiseOnThePhotograph) {
    const Field field = tests::raccoon_field(512);
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        SCOPED_TRACE(std::string(name_of(metric)));
        Request request =
            cells_request(field, tests::scale_of(field, 12, 20'000), metric, Boundary::box);
        request.domain.width = 4;
        request.domain.height = 3;
        expect_all_promises(request);
    }
}
#endif

TEST(CellsSets, FieldsOfOnePixelInAnAxisAndFinerThanTheLattice) {
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
            for (const Field& field : {tests::ramp_field(1, 80), tests::noise_field(1, 80, 1),
                                       tests::noise_field(80, 1, 2), tests::constant_field(1, 1),
                                       tests::noise_field(400, 300, 3)}) {
                SCOPED_TRACE(std::to_string(field.columns) + "x" + std::to_string(field.rows));
                expect_all_promises(
                    cells_request(field, tests::scale_of(field, 1, 50), metric, boundary));
            }
        }
    }
}

// The mean of a small radius and one far larger than the domain is still larger than the domain.
TEST(CellsSets, RadiiFarLargerThanTheDomainCountInFull) {
    const Field field =
        tests::made_field(10, 10, [](double x, double) { return x < 0.5 ? 1 : 1e-8; });
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
            SCOPED_TRACE(std::string(name_of(metric)));
            Request request = cells_request(field, 0.1, metric, boundary);
            for (request.seed = 0; request.seed < 20; ++request.seed) expect_all_promises(request);
        }
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
