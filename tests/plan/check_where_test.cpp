// The errors for requests whose mask, border or kept points cannot be served.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "plan/checked_request.h"
#include "refusal.h"

namespace check_where_test {

using namespace lacuna;

Request of_radius(double radius) {
    Request request;
    request.radius = radius;
    return request;
}

std::string refusal_of(const Request& request) {
    return tests::refusal_of([&] { check_where(request); });
}

TEST(AMask, NeedsAValueForEachPixel) {
    Request request = of_radius(0.1);
    const Mask mask{3, 2, {1, 1, 1, 1, 1}};
    request.mask = &mask;
    EXPECT_EQ(refusal_of(request),
              "mask 3x2 with 5 values: needs columns * rows values, at least one");
}

TEST(AMask, OfZerosHasAnEmptySetAndNoCount) {
    Request request = of_radius(0.1);
    const Mask mask{2, 2, {0, 0, 0, 0}};
    request.mask = &mask;
    EXPECT_EQ(refusal_of(request), "accepted");
    request.radius.reset();
    request.count = 10;
    EXPECT_EQ(refusal_of(request),
              "count 10: points may lie nowhere in the domain, [0, 1) x [0, 1): must be a set "
              "without a count");
}

TEST(AMask, IsForModesExactAndPixels) {
    Request request = of_radius(0.1);
    request.mode = Mode::lines;
    const Mask mask{1, 1, {1}};
    request.mask = &mask;
    EXPECT_EQ(refusal_of(request), "mask with mode lines: is for modes exact and pixels");
}

TEST(ABorder, LeavesRoomWithinIt) {
    Request request = of_radius(0.1);
    request.domain.width = 3;
    const std::string allowed =
        ": must be at least 0 and under half of the domain's shorter side, 0.5";
    for (const auto& [border, text] :
         {std::pair{-0.1, "-0.1"}, std::pair{0.5, "0.5"}, std::pair{std::nan(""), "nan"},
          std::pair{std::numeric_limits<double>::infinity(), "inf"}}) {
        request.border = border;
        EXPECT_EQ(refusal_of(request), "border " + std::string(text) + allowed);
    }
}

TEST(ABorder, IsForBoxesInModeExact) {
    Request request = of_radius(0.1);
    request.border = 0.1;
    request.domain.boundary = Boundary::torus;
    EXPECT_EQ(refusal_of(request), "border 0.1: is not for a torus, which has no edges");
    request.domain.boundary = Boundary::box;
    request.mode = Mode::lines;
    EXPECT_EQ(refusal_of(request), "border with mode lines: is for mode exact only");
}

TEST(AKeptPoint, LiesInATorusOrAnywhereBesideABox) {
    Request request = of_radius(0.1);
    request.domain.width = 2;
    const auto refusal_at = [&](Point outside) {
        const std::vector<Point> keep{{0.5, 0.5}, outside};
        request.keep = keep;
        return refusal_of(request);
    };
    const auto message = [](Point outside, const std::string& domain) {
        return "keep point 1 at (" + shortest(outside.x) + ", " + shortest(outside.y) +
               "): must lie in the domain, " + domain;
    };
    for (const Point outside : {Point{std::nextafter(2, 3), 0.5}, Point{-1e-300, 0.5},
                                Point{1, 1.5}, Point{1, -1}, Point{1e300, 9}}) {
        request.domain.boundary = Boundary::box;
        EXPECT_EQ(refusal_at(outside), "accepted");
        request.domain.boundary = Boundary::torus;
        EXPECT_EQ(refusal_at(outside), message(outside, "[0, 2) x [0, 1)"));
    }
    request.domain.boundary = Boundary::box;
    for (const Point nowhere : {Point{std::nan(""), 0}, Point{0, std::nan("")}})
        EXPECT_EQ(refusal_at(nowhere), message(nowhere, "[0, 2] x [0, 1]"));
    // The upper edges belong to a box, but on a torus they are the lower ones.
    for (const Point corner : {Point{2, 0.5}, Point{1, 1}, Point{2, 1}}) {
        request.domain.boundary = Boundary::box;
        EXPECT_EQ(refusal_at(corner), "accepted");
        request.domain.boundary = Boundary::torus;
        EXPECT_EQ(refusal_at(corner), message(corner, "[0, 2) x [0, 1)"));
    }
}

TEST(AKeptPoint, LiesWithinTheBorder) {
    Request request = of_radius(0.1);
    request.border = 0.25;
    const std::vector<Point> keep{{0.25, 0.75}, {0.5, 0.875}};
    request.keep = keep;
    EXPECT_EQ(refusal_of(request),
              "keep point 1 at (0.5, 0.875): must be at least the border, 0.25, from the domain's "
              "edges");
}

TEST(AKeptPoint, LiesWhereTheMaskAllowsIt) {
    Request request = of_radius(0.1);
    const Mask mask{2, 2, {0, 1, 1, 1}};  // the upper left quarter is forbidden
    request.mask = &mask;
    // A point on the border of two pixels may be taken to lie on either.
    const std::vector<Point> keep{{0.25, 0.25}, {0.5, 0.5}, {0.25, 0.5}, {0.25, 0.5000001}};
    request.keep = keep;
    EXPECT_EQ(refusal_of(request),
              "keep point 3 at (0.25, 0.5000001): must lie where the mask is not 0");
}

TEST(AKeptPoint, LiesWhereTheFieldHasImportance) {
    Request request;
    const Field field{2, 1, {0, 1}};
    request.field = &field;
    request.scale = 0.1;
    const std::vector<Point> keep{{0.75, 0.5}, {0.25, 0.5}};
    request.keep = keep;
    EXPECT_EQ(refusal_of(request),
              "keep point 1 at (0.25, 0.5): must lie where the field is not 0");
}

}  // namespace check_where_test
