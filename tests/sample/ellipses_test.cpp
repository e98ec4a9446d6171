// Ellipses, seen from outside: what is kept, limited and counted. Distances and room are judged
// by hostile.
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

}  // namespace ellipses_test
