// The radius map of mode cells: which pixel lies under a lattice point, and each point's reach.
#include "plan/radius_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>

#include "fields.h"
#include "plan/cells_request.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "portable/metric.h"

namespace {

using namespace lacuna;
using tests::cells_request;

struct Place {
    std::uint32_t x;
    std::uint32_t y;
};

// The squared distance in lattice steps.
double distance_squared(const Plan& plan, Place a, Place b) {
    double dx = std::abs(static_cast<double>(a.x) - b.x);
    double dy = std::abs(static_cast<double>(a.y) - b.y);
    if (plan.period_x != 0) dx = std::min(dx, plan.period_x - dx);
    if (plan.period_y != 0) dy = std::min(dy, plan.period_y - dy);
    return dx * dx + dy * dy;
}

double metric_of(Metric metric, double r, double s) {
    if (metric == Metric::min) return std::min(r, s);
    return metric == Metric::mean ? (r + s) / 2 : std::max(r, s);
}

bool no_conflict_is_beyond_the_reach(const Plan& plan, Place a) {
    const RadiusMap& map = *plan.cells().radii;
    const double r = map.radii[map.pixel_at(a.x, a.y)];
    const double reach = map.reaches[map.pixel_at(a.x, a.y)];
    if (r == 0) return reach == 0;
    for (std::uint32_t x = 0; x < plan.lines; ++x) {
        for (std::uint32_t y = 0; y < plan.height; ++y) {
            const double s = map.radii[map.pixel_at(x, y)];
            if (s == 0) continue;
            const double allowed = metric_of(plan.cells().metric, r, s) / 256;
            const double squared = distance_squared(plan, a, {x, y});
            if (squared < allowed * allowed && squared >= reach * reach) return false;
        }
    }
    return true;
}

// Few pixels are pale, and their disks are small beside the domain. Images have all widths, so that
// the map's blocks have odd ends.
TEST(RadiusMap, NoConflictIsFartherThanTheReachOfEitherPlace) {
    std::mt19937_64 random(20113);
    const auto below = [&](std::uint32_t end) {
        return static_cast<std::uint32_t>(random() % end);
    };
    for (int i = 0; i < 3000; ++i) {
        Field field = tests::constant_field(1 + below(60), 1 + below(8));
        for (std::uint32_t pale = 1 + below(3); pale > 0; --pale)
            field.importance[below(static_cast<std::uint32_t>(field.importance.size()))] =
                std::array{0.0, 0.1, 0.02, 0.005, 0.001}[below(5)];
        Request request = cells_request(field);
        if (*std::max_element(field.importance.begin(), field.importance.end()) == 0) continue;
        request.metric = static_cast<Metric>(below(3));
        request.domain.boundary = i % 4 == 0 ? Boundary::box : Boundary::torus;
        request.domain.height = 0.1 + 0.01 * below(30);
        if (i % 2 == 0) std::swap(request.domain.width, request.domain.height);
        if (i % 2 == 0) std::swap(field.columns, field.rows);
        request.paper2011.lines_per_radius = 1 + below(3);
        request.scale = 0.01 + 0.001 * below(60);
        const Plan plan = make_plan(request);
        const std::uint32_t y = below(plan.height);
        for (std::uint32_t x = 0; x < plan.lines; x += 1 + below(8))
            ASSERT_TRUE(no_conflict_is_beyond_the_reach(plan, {x, y})) << "seed 20113, field " << i;
    }
}

TEST(RadiusMap, ListsTheRowsOfEachPixelColumnByTheirRadiiWidestFirst) {
    const Field field = tests::sizes_field(20, 300, 5);
    Request request = cells_request(field);
    request.scale = 0.01;
    request.metric = Metric::mean;
    const Plan plan = make_plan(request);
    const RadiusMap& radii = *plan.cells().radii;
    ASSERT_EQ(radii.widest_rows.size(), radii.radii.size());
    for (std::uint32_t column = 0; column < radii.columns; ++column) {
        const std::size_t first = std::size_t{column} * radii.rows;
        std::set<std::uint32_t> rows;
        std::uint32_t bound = ~std::uint32_t{0};
        for (std::uint32_t i = 0; i < radii.rows; ++i) {
            const std::uint32_t row = radii.widest_rows[first + i];
            rows.insert(row);
            // Within a class rows come in any order, so the earlier row's bound is compared.
            EXPECT_LE(radii.radii[first + row], bound);
            bound = portable::class_bound(radii.radii[first + row]);
        }
        EXPECT_EQ(rows.size(), radii.rows);
        EXPECT_EQ(*rows.rbegin(), radii.rows - 1);
    }
    request.metric = Metric::min;
    EXPECT_TRUE(make_plan(request).cells().radii->widest_rows.empty());
}

// Radii that do not reach a point do not count there, which makes searches cheap.
TEST(RadiusMap, WideRadiiFarAwayDoNotLengthenAReach) {
    const Field field =
        tests::made_field(100, 100, [](double x, double) { return x < 0.3 ? 0.01 : 1; });
    Request request = cells_request(field);
    request.scale = 0.01;
    request.metric = Metric::max;
    const Plan plan = make_plan(request);
    const auto reach = [&](double x) {
        const auto line = static_cast<std::uint32_t>(x * plan.lines);
        return plan.cells().radii->reaches[plan.cells().radii->pixel_at(line, plan.height / 2)];
    };
    EXPECT_EQ(reach(0.2), 101u);   // 10 steps * sqrt(100), rounded up past it
    EXPECT_EQ(reach(0.35), 101u);  // its neighbours' radius is 0.1
    EXPECT_EQ(reach(0.8), 11u);    // its own
    request.metric = Metric::min;
    EXPECT_EQ(make_plan(request).cells().radii->reaches[plan.cells().radii->pixel_at(350, 500)],
              11u);
}

TEST(RadiusMap, PixelsAreThoseUnderTheMiddleOfTheCells) {
    const Field field = tests::noise_field(7, 5, 2);
    Request request = cells_request(field);
    request.scale = 0.0123;
    const Plan plan = make_plan(request);
    for (std::uint32_t x = 0; x < plan.lines; ++x) {
        const Point point = plan.to_user({x, 0});
        EXPECT_EQ(plan.cells().radii->column_of[x], static_cast<std::uint32_t>(point.x * 7)) << x;
    }
    for (std::uint32_t y = 0; y < plan.height; ++y) {
        const Point point = plan.to_user({0, y});
        const std::uint32_t row = plan.cells().radii->row_of[y];
        EXPECT_EQ(row, static_cast<std::uint32_t>(point.y * 5)) << y;
        EXPECT_GE(y, plan.cells().radii->row_begins[row]);
        EXPECT_LT(y, plan.cells().radii->row_begins[row + 1]);
        // Row 0 of the field is the top.
        const double importance = field.importance[(4 - row) * 7];
        EXPECT_EQ(plan.cells().radii->radii[row] == 0, importance == 0);
    }
}

}  // namespace
