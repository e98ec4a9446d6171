// lacuna::relax keeps its promises: as many points, in the domain, on importance, reproducible.
#include <gtest/gtest.h>

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "judge/judge.h"
#include "refusal.h"
#include "relax/available.h"
#include "relax/scenes.h"

namespace lacuna::relaxing::tests {
namespace {

using lacuna::tests::refusal_of;

class Relax : public OnBackend {};
INSTANTIATE_TEST_SUITE_P(All, Relax, kRelaxBackends, name_of_parameter);

TEST_P(Relax, gives_the_points_of_the_reference_with_any_threads) {
    for (Scene scene : scenes()) {
        scene.options.iterations = 5;
        scene.options.run_on.backend = "reference";
        const Relaxed expected = relax(scene.points, scene.field_or_null(), scene.options);
        for (const std::uint32_t threads : {0U, 1U, 3U, 8U}) {
            scene.options.run_on = {.backend = GetParam(), .threads = threads};
            const Relaxed relaxed = relax(scene.points, scene.field_or_null(), scene.options);
            EXPECT_EQ(relaxed.points, expected.points) << scene << ", " << threads << " threads";
            EXPECT_EQ(relaxed.backend, GetParam());
        }
    }
}

TEST_P(Relax, leaves_no_point_outside_of_the_domain_or_on_white) {
    for (Scene scene : scenes()) {
        scene.options.run_on.backend = GetParam();
        for (const std::uint32_t iterations : {1u, 4u, 15u}) {
            scene.options.iterations = iterations;
            const Relaxed relaxed = relax(scene.points, scene.field_or_null(), scene.options);
            ASSERT_EQ(relaxed.points.size(), scene.points.size()) << scene;
            Request where{.domain = scene.options.domain};
            where.field = scene.field_or_null();
            EXPECT_EQ(judge::Judge(where, relaxed.points, {}, 0).fault(), "") << scene;
        }
    }
}

TEST_P(Relax, takes_points_on_one_spot_apart) {
    for (const std::size_t which : {2u, 3u}) {
        Scene scene = scenes()[which];
        scene.options.run_on.backend = GetParam();
        scene.options.iterations = 60;
        const Relaxed relaxed = relax(scene.points, nullptr, scene.options);
        EXPECT_GT(judge::relative_distance(scene.options.domain, relaxed.points), 0.5) << scene;
    }
}

TEST_P(Relax, evens_shares_out_on_a_torus) {
    Request request;
    request.count = 1024;
    request.domain.boundary = Boundary::torus;
    RelaxOptions options = on(1, 1, Boundary::torus);
    options.run_on.backend = GetParam();
    options.measure = true;
    const std::vector<Point> start = sample(request).points;
    options.iterations = 10;
    const Relaxed ten = relax(start, nullptr, options);
    EXPECT_NEAR(ten.evenness->before, 0.142, 0.02);
    EXPECT_LT(ten.evenness->after, 0.045);
    options.iterations = 30;
    const Relaxed thirty = relax(start, nullptr, options);
    EXPECT_LT(thirty.evenness->after, 0.033);
    EXPECT_LT(thirty.evenness->after_voronoi, 0.05);
    EXPECT_GT(judge::relative_distance(options.domain, thirty.points), 0.65);
}

TEST_P(Relax, is_asked_whether_to_go_on_and_stops) {
    class Stop : public Observer {
    public:
        bool keep_going(const Progress& progress) override {
            EXPECT_EQ(progress.expected_points, 20u * 2000);
            iterations = progress.rounds;
            return progress.rounds < 3;
        }
        std::uint64_t iterations = 0;
    } stop;
    RelaxOptions options = on(1, 1, Boundary::torus);
    options.run_on.backend = GetParam();
    options.iterations = 20;
    EXPECT_THROW(relax(random_points(2000, 1, 1, 1), nullptr, options, stop), Cancelled);
    EXPECT_EQ(stop.iterations, 3u);
}

TEST_P(Relax, is_asked_before_the_first_iteration_too) {
    class Stop : public Observer {
    public:
        explicit Stop(int at) : at_(at) {}
        bool keep_going(const Progress& progress) override {
            rounds = progress.rounds;
            return ++asked < at_;
        }
        int asked = 0;
        std::uint64_t rounds = 0;

    private:
        int at_;
    };
    RelaxOptions options = on(1, 1, Boundary::box);
    options.run_on.backend = GetParam();
    std::vector<Point> points = random_points(200'000, 1, 1, 1);
    points.resize(201'000, {0.5, 0.5});  // a crowd, which must spread
    for (int at = 1; at <= 50; ++at) {
        Stop stop(at);
        EXPECT_THROW(relax(points, nullptr, options, stop), Cancelled);
        EXPECT_EQ(stop.asked, at);
        EXPECT_EQ(stop.rounds, 0u);
    }
}

Relaxed relaxed_from_shares(const Field& field, std::uint64_t count, std::uint32_t iterations) {
    Request request;
    request.mode = Mode::stratified;
    request.field = &field;
    request.domain.width = 1;
    request.domain.height = static_cast<double>(field.rows) / field.columns;
    request.count = count;
    RelaxOptions options = on(request.domain.width, request.domain.height, Boundary::box);
    options.iterations = iterations;
    options.measure = true;
    return relax(sample(request).points, &field, options);
}

// Each of 15 faint islands on white has less than half of a point's importance. If weights had no
// bound, points on islands would take cells in the dark half: 0.35 instead of 0.07.
TEST(FaintIslands, never_take_importance_from_other_shapes) {
    Field field = lacuna::tests::constant_field(100, 100, 0);
    for (std::size_t row = 0; row < 100; ++row)
        for (std::size_t column = 0; column < 100; ++column) {
            const bool is_island = column >= 70 && column % 10 < 6 && row % 20 < 12;
            field.importance[100 * row + column] = column < 50 ? 1 : is_island ? 0.01 : 0;
        }
    double before = 0.12;
    for (const std::uint32_t iterations : {5u, 15u, 60u, 200u}) {
        const Relaxed relaxed = relaxed_from_shares(field, 300, iterations);
        EXPECT_LE(relaxed.evenness->after_voronoi, before) << iterations;
        EXPECT_LE(relaxed.evenness->after, relaxed.evenness->after_voronoi) << iterations;
        before = relaxed.evenness->after_voronoi;
    }
}

constexpr std::size_t kLineWidths = 4;  // 1 to 4 pixels
constexpr std::size_t kLineFrom = 30;   // row
constexpr std::size_t kLineTo = 210;

std::size_t left_of_line(std::size_t width) {
    return 75 * width - 35;
}

Field lines_on_ground(double ground) {
    Field field = lacuna::tests::constant_field(320, 240, ground);
    for (std::size_t width = 1; width <= kLineWidths; ++width)
        for (std::size_t row = kLineFrom; row < kLineTo; ++row)
            for (std::size_t i = 0; i < width; ++i)
                field.importance[320 * row + left_of_line(width) + i] = 1;
    return field;
}

// The points on the lines, over their fair number. A point on half a pixel beside a line counts.
double share_of_lines(const Field& field, const std::vector<Point>& points) {
    double on_lines = 0;
    for (const Point& point : points) {
        const double x = point.x * 320;
        const double y = point.y * 320;
        for (std::size_t width = 1; width <= kLineWidths; ++width) {
            const auto left = static_cast<double>(left_of_line(width));
            const bool is_on = x > left - 0.5 && x < left + static_cast<double>(width) + 0.5 &&
                               y > kLineFrom - 0.5 && y < kLineTo + 0.5;
            on_lines += is_on ? 1 : 0;
        }
    }
    const double all = std::accumulate(field.importance.begin(), field.importance.end(), 0.0);
    const double fair = (kLineTo - kLineFrom) * (1 + 2 + 3 + 4) / all;
    return on_lines / static_cast<double>(points.size()) / fair;
}

// If weights were bounded by areas, points of a line would take each other's cells, and a third of
// them would leave it.
TEST(Lines, keep_their_points_on_grey_ground) {
    for (const double grey : {250, 253}) {
        const Field field = lines_on_ground((255 - grey) / 255);
        for (const std::uint64_t count : {300u, 1000u})
            for (const std::uint32_t iterations : {15u, 60u}) {
                const Relaxed relaxed = relaxed_from_shares(field, count, iterations);
                EXPECT_NEAR(share_of_lines(field, relaxed.points), 1, 0.06)
                    << grey << " " << count << " " << iterations;
            }
    }
}

// A mean of 24 lattice points would leave 2 for each point of a line.
TEST(Lines, get_a_finer_lattice_where_their_points_need_it) {
    const Relaxed on_grey = relaxed_from_shares(lines_on_ground(2.0 / 255), 1000, 1);
    EXPECT_EQ(on_grey.lattice_columns, 640u);
    const Relaxed even = relaxed_from_shares(lines_on_ground(0.9), 1000, 1);
    EXPECT_EQ(even.lattice_columns, 320u);
}

TEST(RelaxOptionsGiven, zero_iterations_change_no_bit) {
    RelaxOptions options;
    options.iterations = 0;
    const std::vector<Point> points = random_points(100, 1, 1, 1);
    EXPECT_EQ(relax(points, nullptr, options).points, points);
}

TEST(RelaxOptionsGiven, no_points_stay_no_points) {
    EXPECT_TRUE(relax({}, nullptr, {}).points.empty());
}

TEST(PointsGiven, are_refused_outside_of_the_domain_and_on_white) {
    const std::vector<Point> middle{{0.5, 0.5}}, outside{{0.5, 1.5}}, nowhere{{std::nan(""), 0.5}};
    const Field white{2, 1, {0, 0}};
    const auto refused = [](const std::vector<Point>& points, const Field* field) {
        return refusal_of([&] { relax(points, field, {}); }).substr(0, 14);
    };
    EXPECT_EQ(refused(outside, nullptr), "points point 0");
    EXPECT_EQ(refused(nowhere, nullptr), "points point 0");
    EXPECT_EQ(refused(middle, &white), "field of zeros");
}

}  // namespace
}  // namespace lacuna::relaxing::tests
