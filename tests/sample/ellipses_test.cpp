// Ellipses, seen from outside: what is kept, limited and counted; refusals in one line. Distances
// and room are judged by hostile.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fields.h"
#include "judge/judge.h"
#include "refusal.h"

namespace ellipses_test {

using namespace lacuna;
using judge::Judge;

Field swirl() {
    return tests::swirled(tests::constant_field(12, 12), 5);
}

Request request_of(const Field& field) {
    Request request;
    request.field = &field;
    request.scale = 0.02;
    request.place.backend = "cpu";
    return request;
}

// At the radius of 16 points the ellipses would be longer than the torus.
TEST(Ellipses, BeginTheirOrderAtALevelWhereTheyFitOnATorus) {
    const Field field = tests::swirled(tests::constant_field(12, 12), 25);
    Request request = request_of(field);
    request.domain.boundary = Boundary::torus;
    request.scale = 0.09;
    request.progressive = true;
    const Result result = sample(request);
    EXPECT_TRUE(result.maximal);
    EXPECT_LE(result.levels.front().size, 0.1);
    EXPECT_EQ(Judge(request, result).fault(), "");
}

TEST(Ellipses, AreRefusedByNumberAndPlace) {
    Field field = swirl();
    Request request = request_of(field);
    const auto refused = [&] { return tests::refusal_of([&] { sample(request); }); };
    field.stretches[14] = {0.5, 0};
    EXPECT_EQ(refused(),
              "stretches 0.5 at an angle of 0 at row 1, column 2: ratios must lie between 1 and "
              "1000, angles between -1000 and 1000");
    field.stretches[14] = {2, std::nan("")};
    EXPECT_EQ(refused(),
              "stretches 2 at an angle of nan at row 1, column 2: ratios must lie between 1 and "
              "1000, angles between -1000 and 1000");
    field.stretches[14] = {2, 1};
    request.mode = Mode::cells;
    EXPECT_EQ(refused(), "stretches with mode cells: are for mode exact");
    request.mode = Mode::exact;
    request.domain.boundary = Boundary::torus;
    request.scale = 0.3;
    EXPECT_EQ(refused(),
              "torus with an ellipse of length 1.34164: must be at most the domain's shorter side, "
              "1");
    request.domain.boundary = Boundary::box;
    field.stretches.pop_back();
    EXPECT_EQ(refused(),
              "stretches 143 values: there must be one for each pixel of the field, 144");
    field = swirl();
    const std::vector<Point> kept{{0.5, 0.9}, {0.5, 0.93}};
    request.keep = kept;
    EXPECT_NE(refused().find("are 0.03"), std::string::npos) << refused();
}

}  // namespace ellipses_test
