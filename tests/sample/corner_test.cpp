// Domains whose lower left corner is not (0, 0): the same sets, moved, with the same promises.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/order.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "judge/plane.h"
#include "refusal.h"

namespace lacuna {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Domain at_corner(Domain domain, double x0, double y0) {
    domain.x0 = x0;
    domain.y0 = y0;
    return domain;
}

std::vector<Point> moved(std::vector<Point> points, const Domain& domain) {
    for (Point& point : points) point = {domain.x0 + point.x, domain.y0 + point.y};
    return points;
}

Field ramp() {
    Field field{8, 4, {}};
    for (int i = 0; i < 32; ++i) field.importance.push_back(0.1 + i % 8 * 0.125);
    return field;
}

// A request of each mode and kind, on a domain of 4 x 2 whose corner is (0, 0). Its kept points are
// whole eighths, so that moving them loses no digit.
struct Kind {
    std::string name;
    Request request;
};

class Corner : public testing::Test {
protected:
    std::vector<Kind> kinds() const {
        std::vector<Kind> all;
        const auto add = [&](const char* name, const auto& change) {
            Request request{.domain = {4, 2}};
            request.seed = 7;
            request.radius = 0.1;
            change(request);
            all.push_back({name, request});
        };
        const auto follow = [](Request& r, const Field& field) {
            r.field = &field;
            r.radius.reset();
            r.scale = 0.07;
        };
        add("exact", [](Request&) {});
        add("torus", [](Request& r) { r.domain.boundary = Boundary::torus; });
        add("lines", [](Request& r) { r.mode = Mode::lines; });
        add("count", [](Request& r) { r.radius.reset(), r.count = 500; });
        add("limit", [](Request& r) { r.limit = 40; });
        add("border", [](Request& r) { r.places.border = 0.3; });
        add("keep", [&](Request& r) { r.keep = keep_; });
        add("mask", [&](Request& r) { r.places.mask = &mask_; });
        add("field", [&](Request& r) { follow(r, field_); });
        add("ellipses", [&](Request& r) { follow(r, stretched_); });
        add("cells", [&](Request& r) { follow(r, field_), r.mode = Mode::cells; });
        add("means in cells",
            [&](Request& r) { follow(r, field_), r.mode = Mode::cells, r.metric = Metric::mean; });
        add("stratified",
            [](Request& r) { r.mode = Mode::stratified, r.radius.reset(), r.count = 300; });
        add("progressive", [&](Request& r) { r.progressive = true, r.keep = keep_; });
        add("classes", [](Request& r) {
            r.radius.reset();
            r.classes = {{"a", "b"}, {0.1, 0.2, 0.2, 0.3}, {}};
        });
        return all;
    }

    // The points are rounded when the corner is added, so the corner's digits need not be few.
    const std::vector<std::array<double, 2>> corners_{
        {448000, -541100}, {-3.25, 0}, {-2, -1}, {0.1, 1e6}, {4194304, -4194304}};

private:
    const std::vector<Point> keep_{{0.5, 0.25}, {0.625, 0.25}, {4, 2}, {0, 1.5}};
    const Field field_ = ramp();
    const Field stretched_ = [] {
        Field field = ramp();
        for (int i = 0; i < 32; ++i) field.stretches.push_back({1 + i % 3 * 1.0, i * 0.1});
        return field;
    }();
    const Mask mask_{4, 2, {1, 1, 0, 1, 1, 0, 1, 1}};
};

TEST_F(Corner, MovesEveryKindOfSet) {
    for (const auto& [x0, y0] : corners_)
        for (const Kind& kind : kinds()) {
            SCOPED_TRACE(kind.name + " at " + std::to_string(x0) + ", " + std::to_string(y0));
            Request request = kind.request;
            const Result expected = sample(request);
            request.domain = at_corner(request.domain, x0, y0);
            const std::vector<Point> kept =
                moved({request.keep.begin(), request.keep.end()}, request.domain);
            request.keep = kept;
            const Result made = sample(request);
            // Radii are longer by what rounding may lose. Where that is over a unit of the grid, or
            // with ellipses, which are not rounded to units, it makes another set of the same kind.
            if (std::abs(x0) < 4194304 && kind.name != "ellipses") {
                EXPECT_TRUE(made.points == moved(expected.points, request.domain));
                EXPECT_EQ(made.classes, expected.classes);
                EXPECT_EQ(made.radius, expected.radius);
                EXPECT_EQ(made.scale, expected.scale);
                EXPECT_EQ(made.maximal, expected.maximal);
            }
            for (const Point& point : made.points)
                ASSERT_TRUE(point.x >= x0 && point.x <= x0 + 4 && point.y >= y0 &&
                            point.y <= y0 + 2);
            if (request.mode == Mode::cells || request.mode == Mode::stratified) continue;
            const Proof proof = prove(made.points, claim_of(request, made));
            EXPECT_TRUE(proof.kept);
            EXPECT_EQ(proof.maximal, made.maximal && request.mode == Mode::exact);
        }
}

TEST_F(Corner, OfAnyDigitsKeepsEveryPromise) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus})
        for (const auto& [width, height, x0, y0] :
             std::vector<std::array<double, 4>>{{2000, 1500, 448000, 5411000},
                                                {2000, 2000, 1e9, -1e9},
                                                {0.7, 0.3, 0.1, 0.1},
                                                {0.1, 0.3, -0.1, -0.3},
                                                {0.3, 0.1, 1e-17, -1e-300},
                                                {1, 1, 1048576, -1048576},
                                                {0.001, 0.01, 11.58, 48.83},
                                                {1e-9, 1e-9, 1.0 / 3e5, 1e-4},
                                                {1e20, 7e19, 1e26, -3e25}}) {
            Request request;
            request.domain = at_corner({width, height, boundary}, x0, y0);
            // A sampler that lost half a unit anywhere would show it at one of these radii: the
            // rounding up to whole units of the grid is different at each.
            for (int i = 0; i < 40; ++i) {
                request.seed = static_cast<std::uint64_t>(i);
                request.radius = std::min(width, height) / (4 + i * 0.173);
                const Result made = sample(request);
                EXPECT_GE(judge::closest_pair(request.domain, made.points).distance,
                          *request.radius)
                    << x0 << ", " << y0 << ", radius " << *request.radius;
                for (const Point& point : made.points) {
                    EXPECT_TRUE(x0 <= point.x && point.x < x0 + width);
                    EXPECT_TRUE(y0 <= point.y && point.y < y0 + height);
                }
                EXPECT_TRUE(prove(made.points, claim_of(request, made)).maximal);
            }
        }
}

TEST_F(Corner, MovesWhatIsRelaxedOrderedOrDrawn) {
    const Field field = ramp();
    Field stretched = ramp();
    for (int i = 0; i < 32; ++i) stretched.stretches.push_back({2, i * 0.1});
    for (const Boundary boundary : {Boundary::box, Boundary::torus})
        for (const auto& [x0, y0] : corners_) {
            SCOPED_TRACE(std::to_string(x0) + ", " + std::to_string(y0));
            Request request{.domain = {4, 2, boundary}};
            request.radius = 0.125;
            std::vector<Point> points = sample(request).points;
            for (Point& point : points)  // so that moving them loses no digit
                point = {std::round(point.x * 1024) / 1024, std::round(point.y * 1024) / 1024};
            if (x0 == 0.1) continue;
            const Domain domain = at_corner(request.domain, x0, y0);
            const std::vector<Point> there = moved(points, domain);
            const auto expect_moved = [&](const Field* picture, RelaxOptions options) {
                options.domain = request.domain;
                const std::vector<Point> expected = relax(points, picture, options).points;
                options.domain = domain;
                EXPECT_TRUE(relax(there, picture, options).points == moved(expected, domain));
            };
            expect_moved(nullptr, {.iterations = 3});
            expect_moved(&field, {.iterations = 3});
            expect_moved(nullptr, {.iterations = 0, .gaussian = 5});
            for (const Field* picture : {static_cast<const Field*>(nullptr), &field})
                EXPECT_EQ(progressive_order(there, picture, {domain, 3}),
                          progressive_order(points, picture, {request.domain, 3}));
            EXPECT_EQ(ellipses_of(there, stretched, 0.1, domain).size(), points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_EQ(ellipses_of(there, stretched, 0.1, domain)[i].angle,
                          ellipses_of(points, stretched, 0.1, request.domain)[i].angle);
            EXPECT_EQ(least_distance(there, domain), least_distance(points, request.domain));
        }
}

TEST_F(Corner, IsWhereKeptAndOtherPointsMustLie) {
    Request request{.domain = at_corner({2, 1}, 10, -20), .radius = 0.1};
    const std::vector<Point> low{{0.5, 0.5}}, edge{{12, -19}};
    EXPECT_EQ(tests::refusal_of([&] { relax(low, nullptr, {.domain = request.domain}); }),
              "points point 0 at (0.5, 0.5): must lie in the domain, [10, 12] x [-20, -19]");
    request.keep = edge;
    EXPECT_TRUE(sample(request).maximal);
    request.domain.boundary = Boundary::torus;
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "keep point 0 at (12, -19): must lie in the domain, [10, 12) x [-20, -19)");
}

}  // namespace
}  // namespace lacuna
