// The plan's promises about whole numbers, and the requests that it refuses.
#include "plan/plan.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <bit>
#include <cmath>
#include <limits>

#include "plan/checked_request.h"
#include "plan/make_plan.h"
#include "plan/sizes.h"
#include "refusal.h"

namespace plan_test {

using namespace lacuna;

Request with_radius(double radius) {
    Request request;
    request.radius = radius;
    return request;
}

Request in_mode(Mode mode, double radius) {
    Request request = with_radius(radius);
    request.mode = mode;
    return request;
}

// Moves the corner of the domain to where one may be, or leaves it at (0, 0).
void move_corner(Domain& domain) {
    const double scale = domain.longer_side() * *rc::gen::element(0.0, 1.0, 1e-3, 1e-6 / 3);
    domain.x0 = *rc::gen::inRange(-1048576, 1048577) * scale;
    domain.y0 = *rc::gen::inRange(-1048576, 1048577) * scale;
}

TEST(Plan, HasTheNumberOfLinesOfThePaper) {
    EXPECT_EQ(make_plan(in_mode(Mode::lines, 0.01)).lines, 3000u);
    EXPECT_EQ(make_plan(in_mode(Mode::lines, 0.001)).lines, 30000u);
    Request wide = in_mode(Mode::lines, 0.3);
    wide.domain.width = 2;
    wide.paper2011.lines_per_radius = 1;
    EXPECT_EQ(make_plan(wide).lines, 7u);
}

TEST(Plan, HasFewerLinesInExactUnlessToldHowMany) {
    EXPECT_EQ(make_plan(in_mode(Mode::exact, 0.01)).lines, 600u);
    EXPECT_EQ(make_plan(in_mode(Mode::exact, 0.01)).lines_per_radius, 6u);
    EXPECT_EQ(make_plan(in_mode(Mode::lines, 0.01)).lines_per_radius, 30u);
    Request told = in_mode(Mode::exact, 0.01);
    told.paper2011.lines_per_radius = 30;
    EXPECT_EQ(make_plan(told).lines, 3000u);
}

RC_GTEST_PROP(Plan, KeepsEveryPromiseOfItsFields, ()) {
    Request request;
    request.mode = *rc::gen::element(Mode::exact, Mode::lines);
    request.domain.width = *rc::gen::inRange(1, 1000) / 100.0;
    request.domain.height = *rc::gen::inRange(1, 1000) / 100.0;
    request.domain.boundary = *rc::gen::element(Boundary::box, Boundary::torus);
    request.paper2011.lines_per_radius = *rc::gen::inRange(1u, 1001u);
    const double longer = request.domain.longer_side();
    const double shorter = request.domain.shorter_side();
    request.radius = std::max(shorter * *rc::gen::inRange(1, 10001) / 10000, longer * 2e-5);
    request.limit = 1;
    request.run_on.memory_limit_bytes = std::uint64_t{1} << 50;
    if (*request.radius > shorter) return;
    move_corner(request.domain);

    const Plan plan = make_plan(request);
    RC_ASSERT(plan.lines * std::uint64_t{plan.strip_width} == plan.width);
    RC_ASSERT(plan.strip_width >= 2u && plan.strip_width % 2 == 0);
    RC_ASSERT(plan.width <= 0x80000000u && plan.height <= 0x80000000u);
    RC_ASSERT(plan.width > 0u && plan.height > 0u);
    if (plan.is_exact()) RC_ASSERT(std::has_single_bit(plan.strip_width));
    // In exact strip widths are rounded down to a power of two: at least half of 2^31 units remain.
    if (plan.is_exact()) RC_ASSERT(std::max(plan.width, plan.height) >= (1u << 30));
    RC_ASSERT(plan.radius * std::min(plan.unit_x, plan.unit_y) >= *request.radius);
    RC_ASSERT((plan.radius - 2) * std::min(plan.unit_x, plan.unit_y) <= *request.radius);
    RC_ASSERT(std::abs(plan.unit_y / plan.unit_x - 1) < std::ldexp(1, -20));
    // A radius has m strips, or a few thousandths more.
    RC_ASSERT(plan.strip_width * std::uint64_t{*request.paper2011.lines_per_radius} <= plan.radius);
    const Point last = plan.to_user({plan.width - 1, plan.height - 1});
    RC_ASSERT(last.x < request.domain.x0 + request.domain.width);
    RC_ASSERT(last.y < request.domain.y0 + request.domain.height);
    const Point first = plan.to_user({0, 0});
    RC_ASSERT(first.x == request.domain.x0 && first.y == request.domain.y0);
}

// A user's check in double never finds less than the radius, for samples exactly plan.radius apart.
RC_GTEST_PROP(Plan, RoundsDistancesInTheUsersFavour, ()) {
    Request request;
    request.mode = *rc::gen::element(Mode::exact, Mode::lines);
    request.domain.width = *rc::gen::inRange(1, 100000) / 7919.0;
    request.domain.height = request.domain.width * *rc::gen::inRange(1, 1000) / 997.0;
    if (request.domain.height * 1000 < request.domain.width) return;
    request.radius = request.domain.shorter_side() / *rc::gen::inRange(2, 2000);
    // Less is refused.
    if (*request.radius < std::ldexp(request.domain.longer_side(), -20)) return;
    request.run_on.memory_limit_bytes = std::uint64_t{1} << 50;
    move_corner(request.domain);
    const bool has_field = request.mode == Mode::exact && *rc::gen::inRange(0, 4) == 0;
    if (has_field) request.places.border = request.domain.shorter_side() * 1e-6;
    const Plan plan = make_plan(request);
    const auto x = *rc::gen::inRange<std::uint32_t>(0, plan.width - plan.radius);
    const auto y = *rc::gen::inRange<std::uint32_t>(0, plan.height);
    const Point a = plan.to_user({x, y});
    const Point b = plan.to_user({x + plan.radius, y});
    RC_ASSERT(std::sqrt((a.x - b.x) * (a.x - b.x)) >= *request.radius);
    const Point c = plan.to_user({y % plan.width, 0});
    const Point d = plan.to_user({y % plan.width, plan.radius});
    RC_ASSERT(std::sqrt((c.y - d.y) * (c.y - d.y)) >= *request.radius);
}

std::string refusal(const Request& request) {
    return tests::refusal_of([&] { make_plan(request); });
}

TEST(Plan, SaysHowMuchMemoryASmallRadiusNeeds) {
    Request request = with_radius(1e-5);
    request.run_on.memory_limit_bytes = 1'000'000'000;
    const std::string message = refusal(request);
    EXPECT_NE(message.find("radius 1e-05: needs about "), std::string::npos) << message;
    EXPECT_NE(message.find(" GB of memory, more than the 1 GB there is"), std::string::npos);
    EXPECT_THROW(make_plan(request), MemoryRefused);
}

TEST(Plan, NeedsLessMemoryForFewPoints) {
    Request request = with_radius(2e-5);
    request.run_on.memory_limit_bytes = 100'000'000'000;
    EXPECT_NE(refusal(request).find("needs about"), std::string::npos);
    request.limit = 1000;
    EXPECT_EQ(refusal(request), "accepted");
    request.run_on.memory_limit_bytes = 1'000'000'000;  // a grid of 5e9 cells does not fit
    EXPECT_NE(refusal(request).find("needs about 4"), std::string::npos) << refusal(request);
}

TEST(Plan, RefusesRoundsThatNoMemoryHolds) {
    Request request = with_radius(0.1);
    request.paper2011.round_size = std::uint64_t{1} << 32;
    EXPECT_EQ(refusal(request), "round-size 4294967296: must be at most 2147483648");
    request.paper2011.round_size = 100'000'000;
    request.run_on.memory_limit_bytes = 1'000'000'000;
    EXPECT_EQ(refusal(request).find("round-size 100000000: needs about 9.6 GB of memory"), 0u)
        << refusal(request);
    request.run_on.memory_limit_bytes = 10'000'000'000;
    EXPECT_EQ(refusal(request), "accepted");
}

TEST(ACheckedRequest, IsSettled) {
    EXPECT_THROW(CheckedRequest(Request{}), BadRequest);
    Request request;
    request.classes = {.names = {"a", "b"}, .distances = {0.2, 0.1, 0.1, 0.3}, .weights = {}};
    EXPECT_EQ(CheckedRequest(request)->radius, 0.1);
    request.classes = {.names = {"a"}, .distances = {0.2}, .weights = {}};
    const CheckedRequest one = request;
    EXPECT_EQ(one->radius, 0.2);
    EXPECT_TRUE(one->classes.names.empty());
    EXPECT_EQ(one.with([](Request& changed) { changed.radius = 0.1; })->radius, 0.1);
}

}  // namespace plan_test
