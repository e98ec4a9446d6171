// Where kept points may lie.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <string>
#include <vector>

#include "plan/checked_request.h"
#include "refusal.h"

namespace check_where_test {

using namespace lacuna;

// The number of the kept point that is refused, or "accepted".
std::string refused(Request request, const std::vector<Point>& keep) {
    request.keep = keep;
    const std::string told = tests::refusal_of([&] { check_where(request); });
    return told.starts_with("keep point ") ? told.substr(11, told.find(" at ") - 11) : told;
}

TEST(AKeptPoint, LiesInATorusOrAnywhereBesideABox) {
    const Request box{.domain = {2, 1}, .radius = 0.1};
    const Request torus{.domain = {2, 1, Boundary::torus}, .radius = 0.1};
    // The upper edges belong to a box, but on a torus they are the lower ones.
    for (const Point outside :
         {Point{std::nextafter(2, 3), 0.5}, Point{-1e-300, 0.5}, Point{1, 1.5}, Point{1, -1},
          Point{1e300, 9}, Point{2, 0.5}, Point{1, 1}, Point{2, 1}}) {
        EXPECT_EQ(refused(box, {{0.5, 0.5}, outside}), "accepted");
        EXPECT_EQ(refused(torus, {{0.5, 0.5}, outside}), "1");
    }
    for (const Point nowhere : {Point{std::nan(""), 0}, Point{0, std::nan("")}})
        EXPECT_EQ(refused(box, {{0.5, 0.5}, nowhere}), "1");
}

TEST(AKeptPoint, LiesWhereTheMaskAndTheFieldAllowIt) {
    const Mask mask{2, 2, {0, 1, 1, 1}};  // the upper left quarter is forbidden
    const Request masked{.radius = 0.1, .places = {.mask = &mask}};
    // A point on the border of two pixels may be taken to lie on either.
    EXPECT_EQ(refused(masked, {{0.25, 0.25}, {0.5, 0.5}, {0.25, 0.5}, {0.25, 0.5000001}}), "3");
    const Field field{2, 1, {0, 1}};
    EXPECT_EQ(refused({.field = &field, .scale = 0.1}, {{0.75, 0.5}, {0.25, 0.5}}), "1");
}

}  // namespace check_where_test
