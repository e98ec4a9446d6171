// The plan of mode cells, and the requests that it refuses.
#include "plan/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "fields.h"
#include "plan/cells_request.h"
#include "plan/make_plan.h"
#include "refusal.h"

namespace {

using namespace lacuna;
using tests::cells_request;

std::string refusal(const Request& request) {
    return tests::refusal_of([&] { sample(request); });
}

TEST(CellsPlan, CountsTheStepsOfTheHeightToo) {
    const Field field = tests::constant_field(3, 2, 4);
    Request request = cells_request(field);
    request.domain.height = 1000;
    request.scale = 0.1;
    EXPECT_NE(refusal(request).find(" steps long, of at most "), std::string::npos);
}

TEST(CellsPlan, SaysHowMuchMemoryASetNeeds) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    request.run_on.memory_limit_bytes = 1'000'000;
    request.scale = 0.001;
    std::string message = refusal(request);
    EXPECT_EQ(message.find("scale 0.001: needs about 0.05"), 0u) << message;
    EXPECT_NE(message.find(" GB of memory, more than the 0.001 GB there is"), std::string::npos);
    request.scale.reset();
    request.count = 500'000;
    message = refusal(request);
    EXPECT_EQ(message.find("count 500000: needs about 0.0"), 0u) << message;
}

// More points than one pixel of any lattice has room for; the rest of the field is white.
TEST(CellsPlan, RefusesMorePointsThanLatticePoints) {
    Field field = tests::constant_field(1000, 1000, 0);
    field.importance[777'123] = 1;
    Request request = cells_request(field);
    request.scale.reset();
    request.count = 1'000'000;
    const std::string message = refusal(request);
    EXPECT_EQ(message.find("count 1000000: makes the least radius "), 0u) << message;
}

// If the two steps differ more, distances are wrong: a radius is counted in the smaller step.
TEST(CellsPlan, HasStepsAlikeAtEveryAspect) {
    const Field field = tests::constant_field(2, 2);
    for (const double aspect : {1.0, 7.0, 30.0, 1000.0}) {
        for (const double scale : {0.2, 0.9, 8.0, 60.0, 125.0, 900.0, 5000.0}) {
            for (const bool is_wide : {true, false}) {
                Request request = cells_request(field);
                (is_wide ? request.domain.width : request.domain.height) = aspect;
                request.scale = scale;
                const Plan plan = make_plan(request);
                EXPECT_LE(std::abs(plan.lines * request.domain.height / request.domain.width -
                                   plan.height),
                          0.5)
                    << request.domain.width << "x" << request.domain.height << " at scale "
                    << scale;
                EXPECT_GE(plan.lines, 10 * request.domain.width / scale);
            }
        }
    }
}

TEST(CellsPlan, TakesNumbersOfAnySize) {
    for (const double size : {1e-90, 1.0, 1e90}) {
        for (const double importance : {1e-300, 1e-12, 1e12, 1e300}) {
            const Field field = tests::constant_field(3, 2, importance);
            Request request = cells_request(field);
            request.domain.width = request.domain.height = size;
            request.scale.reset();
            request.count = 100;
            const Result result = sample(request);
            EXPECT_EQ(result.points.size(), 100u) << size << ", " << importance;
            EXPECT_NEAR(result.radius / size, 0.08, 0.02);
        }
    }
    // Values whose sum is infinite.
    const Field field = tests::constant_field(30, 20, 1e307);
    Request request = cells_request(field);
    request.scale = 0.1 * std::sqrt(1e307);
    EXPECT_NEAR(static_cast<double>(sample(request).points.size()), 80, 20);
}

}  // namespace
