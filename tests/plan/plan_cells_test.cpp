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

TEST(CellsPlan, NeedsAField) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    EXPECT_EQ(refusal(request), "accepted");
    request.field = nullptr;
    EXPECT_EQ(refusal(request), "field missing: mode cells needs one");
}

TEST(CellsPlan, RefusesAFieldThatIsNoRectangle) {
    Field field{3, 2, std::vector<double>(5, 1.0)};
    const std::string needs = ": needs columns * rows values, at least one";
    EXPECT_EQ(refusal(cells_request(field)), "field 3x2 with 5 values" + needs);
    field.importance.resize(7);
    EXPECT_EQ(refusal(cells_request(field)), "field 3x2 with 7 values" + needs);
    field = {0, 4, {}};
    EXPECT_EQ(refusal(cells_request(field)), "field 0x4 with 0 values" + needs);
    // Numbers whose product wraps in 32 bits are refused, too.
    field = {65536, 65536, {}};
    EXPECT_EQ(refusal(cells_request(field)), "field 65536x65536 with 0 values" + needs);
}

TEST(CellsPlan, NamesTheFirstValueThatIsNoImportance) {
    Field field = tests::constant_field(3, 2);
    const std::string must = ": importance must be a finite number of at least 0";
    field.importance[5] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(cells_request(field)), "field inf at row 1, column 2" + must);
    field.importance[4] = -0.5;
    EXPECT_EQ(refusal(cells_request(field)), "field -0.5 at row 1, column 1" + must);
    field.importance[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(cells_request(field)), "field nan at row 0, column 2" + must);
}

TEST(CellsPlan, RefusesAFieldOfZeros) {
    Field field = tests::constant_field(3, 2, 0);
    EXPECT_EQ(refusal(cells_request(field)),
              "field of zeros: some importance must be greater than 0");
    field.importance[3] = -0.0;
    EXPECT_EQ(refusal(cells_request(field)),
              "field of zeros: some importance must be greater than 0");
}

TEST(CellsPlan, TakesAScaleOrACountAndNoRadius) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    request.count = 10;
    EXPECT_EQ(refusal(request), "scale 0.1: give either a scale or a count");
    request.scale.reset();
    request.count.reset();
    EXPECT_EQ(refusal(request), "scale missing: give either a scale or a count");
    request.radius = 0.25;
    EXPECT_EQ(refusal(request), "radius 0.25: is not for a field: give a scale or a count");
    request.radius.reset();
    request.count = 0;
    EXPECT_EQ(refusal(request), "count 0: must be at least 1");
}

TEST(CellsPlan, RefusesAScaleThatIsNone) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    const std::string must = ": must be a finite number greater than 0";
    request.scale = 0;
    EXPECT_EQ(refusal(request), "scale 0" + must);
    request.scale = -1;
    EXPECT_EQ(refusal(request), "scale -1" + must);
    request.scale = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(request), "scale nan" + must);
    request.scale = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(request), "scale inf" + must);
}

TEST(CellsPlan, KeepsWhatIsForOneModeToThatMode) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    request.paper2011.snap = true;
    EXPECT_EQ(refusal(request), "snap with mode cells: is for mode lines only");
    request.paper2011.snap = false;
    request.paper2011.uniform_x = true;
    EXPECT_EQ(refusal(request), "uniform-x with mode cells: is for mode lines only");
    Request other;
    other.mode = Mode::lines;
    other.scale = 0.5;
    EXPECT_EQ(refusal(other), "scale 0.5: is for a field");
    other.field = &field;
    EXPECT_EQ(refusal(other), "field with mode lines: is for modes exact and cells");
}

TEST(CellsPlan, RefusesALatticeOfTooManyStepsByTheNameOfTheOptionGiven) {
    const Field field = tests::constant_field(3, 2, 4);
    Request request = cells_request(field);
    request.scale = 1e-5;
    EXPECT_EQ(refusal(request),
              "scale 1e-05: makes the least radius 5e-06 and the lattice 2e+06 steps long, of "
              "at most 131072: ask for a larger scale or fewer lines per radius");
    request.scale.reset();
    request.count = 1'000'000'000'000;
    const std::string message = refusal(request);
    EXPECT_EQ(message.find("count 1000000000000: makes the least radius "), 0u) << message;
    EXPECT_NE(
        message.find(" steps long, of at most 131072: ask for fewer points or fewer lines per "
                     "radius"),
        std::string::npos)
        << message;
    // The height counts too.
    request = cells_request(field);
    request.domain.height = 1000;
    request.scale = 0.1;
    EXPECT_NE(refusal(request).find(" steps long, of at most 131072"), std::string::npos);
}

TEST(CellsPlan, SaysHowMuchMemoryASetNeeds) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    request.place.memory_limit_bytes = 1'000'000;
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

TEST(CellsPlan, RefusesMOutsideItsRange) {
    const Field field = tests::constant_field(3, 2);
    Request request = cells_request(field);
    for (const std::uint32_t m : {0u, 1001u}) {
        request.paper2011.lines_per_radius = m;
        EXPECT_EQ(refusal(request),
                  "lines-per-radius " + std::to_string(m) + ": must be between 1 and 1000");
    }
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
