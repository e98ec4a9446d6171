// The promises of lacuna.h for mode exact with a field, a mask, a border and kept points, seen from
// outside: distances and room in double, the kept points, and refusals in one line.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "backends/radius_field_requests.h"
#include "refusal.h"
#include "sample/distance.h"

namespace {

using namespace lacuna;
using tests::FieldRequest;

// A user's computation. Pixels are cut at their borders to 2^-28 of the longer side, so a point
// counts as near a border up to that distance.
class Plane {
public:
    explicit Plane(const Request& request)
        : request_(request), blur_(request.domain.longer_side() * 0x1p-28) {}

    double distance(Point a, Point b) const { return tests::distance_on(request_.domain, a, b); }
    // 0 where no sample may be.
    double radius_at(Point p) const {
        const double border = request_.border;
        if (p.x < border || p.y < border || request_.domain.width - p.x < border ||
            request_.domain.height - p.y < border)
            return 0;
        if (request_.mask != nullptr && value_at(*request_.mask, request_.mask->allowed, p) == 0)
            return 0;
        if (request_.field == nullptr) return *request_.radius;
        const double importance = value_at(*request_.field, request_.field->importance, p);
        return importance == 0 ? 0 : *request_.scale / std::sqrt(importance);
    }
    // The least and the greatest radius that a point this near to borders may have.
    double least_radius_at(Point p) const { return of_corners(p, true); }
    double greatest_radius_at(Point p) const { return of_corners(p, false); }
    double blur() const { return blur_; }

private:
    template <typename Pixels, typename Values>
    double value_at(const Pixels& pixels, const Values& values, Point p) const {
        const auto along = [](double share, std::uint32_t count) {
            return static_cast<std::uint32_t>(
                std::clamp(std::floor(share * count), 0.0, count - 1.0));
        };
        const std::uint32_t column = along(p.x / request_.domain.width, pixels.columns);
        const std::uint32_t row =
            pixels.rows - 1 - along(p.y / request_.domain.height, pixels.rows);
        return static_cast<double>(values[std::size_t{row} * pixels.columns + column]);
    }
    double of_corners(Point p, bool least) const {
        double radius = least ? std::numeric_limits<double>::infinity() : 0;
        for (const double dx : {-blur_, blur_})
            for (const double dy : {-blur_, blur_}) {
                const double there = radius_at({p.x + dx, p.y + dy});
                radius = least ? std::min(radius, there) : std::max(radius, there);
            }
        return radius;
    }

    const Request& request_;
    double blur_;
};

void expect_that_promises_are_kept(const FieldRequest& made, const Result& result) {
    const Request& request = made.request;
    const Plane plane(request);
    const std::vector<Point>& points = result.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_GT(plane.greatest_radius_at(points[i]), 0) << "point " << i;
        for (std::size_t j = 0; j < i; ++j) {
            const double limit =
                std::min(plane.least_radius_at(points[i]), plane.least_radius_at(points[j]));
            EXPECT_GE(plane.distance(points[i], points[j]), limit) << i << " and " << j;
        }
        for (const Point& kept : request.keep)
            if (!request.domain.holds(kept)) {
                EXPECT_GE(plane.distance(points[i], kept), *request.radius) << i;
            }
    }
    if (!result.maximal) return;
    // Wherever a sample could lie, another one is nearer than both radii. Checked at random, beside
    // samples and at the corners of pixels, where gaps would be.
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> share(0, 1);
    for (int k = 0; k < 3000; ++k) {
        Point spot{share(random) * request.domain.width, share(random) * request.domain.height};
        if (k % 3 == 1 && !points.empty()) {
            const Point near = points[random() % points.size()];
            const double angle = 6.2831853 * share(random);
            const double radius = 1.0001 * plane.radius_at(near);
            spot = {near.x + radius * std::cos(angle), near.y + radius * std::sin(angle)};
            if (spot.x < 0 || spot.x >= request.domain.width || spot.y < 0 ||
                spot.y >= request.domain.height)
                continue;
        }
        const double radius = plane.least_radius_at(spot);
        if (radius == 0) continue;
        const bool is_covered = std::any_of(points.begin(), points.end(), [&](const Point& point) {
            return plane.distance(spot, point) <
                   std::min(plane.greatest_radius_at(spot), plane.greatest_radius_at(point)) +
                       plane.blur();
        });
        const auto covers = [&](const Point& kept) {
            return request.field == nullptr && !request.domain.holds(kept) &&
                   plane.distance(spot, kept) < *request.radius + plane.blur();
        };
        EXPECT_TRUE(is_covered || std::any_of(request.keep.begin(), request.keep.end(), covers))
            << "(" << spot.x << ", " << spot.y << ")";
    }
}

TEST(ASetWithARadiusField, KeepsWhatIsPromisedOnEveryKindOfRequest) {
    for (FieldRequest made : tests::radius_field_requests()) {
        SCOPED_TRACE(made.name);
        if (made.name.find("threads share") != std::string::npos) continue;  // too many for pairs
        made.request.place.backend = "cpu";
        const Result result = sample(made.request);
        EXPECT_EQ(result.maximal, !made.request.limit);
        expect_that_promises_are_kept(made, result);
    }
}

TEST(ASetWithARadiusField, OfSoManyPointsHasSoMany) {
    for (const std::uint64_t count : {1u, 2u, 50u, 3000u}) {
        FieldRequest made = tests::radius_field_request("a count", tests::noise_field(20, 20, 4), 1,
                                                        Boundary::torus);
        made.request.scale.reset();
        made.request.count = count;
        const Result result = sample(made.request);
        EXPECT_EQ(result.points.size(), count);
        made.request.count.reset();
        made.request.scale = result.scale;
        const Result maximal = sample(made.request);
        EXPECT_TRUE(std::equal(result.points.begin(), result.points.end(), maximal.points.begin()));
    }
}

// The middle of the only row of the mask lies where the field is 0.
TEST(ASetWithARadiusField, OfACountOnAMaskThatIsCoarserThanTheField) {
    const Field field{1, 3, {1, 0, 0.5}};
    Mask mask{4, 1, {1, 0, 1, 1}};
    Request request;
    request.field = &field;
    request.mask = &mask;
    request.count = 50;
    EXPECT_EQ(sample(request).points.size(), 50U);
    // Of the left pixel of the field the right fifth is allowed, and the middle of no pixel there.
    const Field fifth{2, 1, {1, 0}};
    mask = {5, 1, {0, 0, 1, 0, 0}};
    request.field = &fifth;
    EXPECT_EQ(sample(request).points.size(), 50U);
    const Field left{2, 1, {1, 0}};
    mask = {2, 1, {0, 1}};
    request.field = &left;
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "count 50: has no room: the field is 0 where the mask allows samples");
}

TEST(KeptPoints, ComeFirstAndToTheBitAndASetThatWasCutShortBecomesMaximal) {
    FieldRequest made =
        tests::radius_field_request("resumed", tests::ramp_field(16, 16), 500, Boundary::torus);
    made.request.limit = 200;
    const std::vector<Point> cut = sample(made.request).points;
    made.request.limit.reset();
    made.request.seed = 9;
    made = with_keep(made, cut);
    const Result whole = sample(made.request);
    EXPECT_TRUE(whole.maximal);
    ASSERT_GT(whole.points.size(), cut.size());
    EXPECT_TRUE(std::equal(cut.begin(), cut.end(), whole.points.begin()));
    expect_that_promises_are_kept(made, whole);
}

// Such points count as lying on the pixel beside them (check_keep.cpp), and have its radius.
TEST(KeptPoints, ThatLieWithin2ToTheMinus28OfWhereSamplesMayKeepTheirDistance) {
    const Mask left{2, 1, {1, 0}};
    const Field field{2, 1, {1, 0}};
    for (const bool has_field : {false, true}) {
        FieldRequest made = tests::uniform("kept beside", 0.1, Boundary::box);
        if (has_field) {
            made.request.radius.reset();
            made.request.scale = 0.1;
            made.request.field = &field;
        } else {
            made.request.mask = &left;
        }
        std::vector<Point> beside;
        for (const double y : {0.1, 0.3, 0.5, 0.7, 0.9}) beside.push_back({0.5 + 0x1.8p-29, y});
        made = with_keep(made, beside);
        const Result result = sample(made.request);
        Claim claim;
        claim.radius = claim.scale = 0.1;
        claim.field = made.request.field;
        claim.mask = made.request.mask;
        claim.keep = beside;
        const Proof proof = prove(result.points, claim);
        EXPECT_GE(proof.least_distance, 0.1) << proof.first << " and " << proof.second;
        EXPECT_TRUE(proof.maximal);
    }
}

TEST(KeptPoints, CountForALimit) {
    FieldRequest made = tests::uniform("kept", 0.05, Boundary::box);
    made.request.limit = 30;
    const std::vector<Point> cut = sample(made.request).points;
    made = with_keep(made, cut);
    EXPECT_EQ(sample(made.request).points, cut);
    made.request.limit = 31;
    EXPECT_EQ(sample(made.request).points.size(), 31u);
}

std::string refusal_of(const Request& request) {
    return tests::refusal_of([&] { sample(request); });
}

TEST(ARequestWithARadiusField, IsRefusedInOneLineWhereItMakesNoSense) {
    const Field field = tests::ramp_field(4, 4);
    Request request;
    request.field = &field;
    request.scale = 0.1;
    request.metric = Metric::mean;
    EXPECT_EQ(refusal_of(request), "metric mean: is for mode cells; mode exact knows min");
    request.metric = Metric::min;
    request.mode = Mode::lines;
    EXPECT_EQ(refusal_of(request), "field with mode lines: is for modes exact and cells");
    request.mode = Mode::exact;
    request.radius = 0.1;
    EXPECT_EQ(refusal_of(request), "radius 0.1: is not for a field: give a scale or a count");
    request.radius.reset();
    request.scale = 1e-9;
    EXPECT_NE(refusal_of(request).find("the longer side / 2^20"), std::string::npos);
    request.scale = 0.1;
    request.field = nullptr;
    EXPECT_EQ(refusal_of(request), "scale 0.1: is for a field");
}

}  // namespace
