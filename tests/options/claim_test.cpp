// claim_of: what sets of other modes than exact promise. Sets of all kinds are proven by their
// claims in hostile.
#include <gtest/gtest.h>
#include <lacuna/verify.h>

namespace lacuna {
namespace {

const Field kField{2, 1, {1, 0.25}};

TEST(Claims, OfLinesHaveTheDistanceThatInterpolationLeaves) {
    Request request;
    request.radius = 0.1;
    request.mode = Mode::lines;
    request.paper2011.lines_per_radius = 5;
    const Result result = sample(request);
    EXPECT_DOUBLE_EQ(claim_of(request, result).radius, 0.09);
    request.paper2011.snap = true;
    EXPECT_EQ(claim_of(request, result).radius, 0.1);
}

TEST(Claims, OfAStratifiedSetAreItsRadius) {
    Request request;
    request.count = 50;
    request.mode = Mode::stratified;
    request.field = &kField;
    Result result = sample(request);
    result.radius = least_distance(result.points);
    const Claim claim = claim_of(request, result);
    EXPECT_EQ(claim.field, nullptr);
    EXPECT_TRUE(prove(result.points, claim).kept);
}

TEST(Claims, OfPixelsAreThatNoPixelHasTwoPoints) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        Request request;
        request.domain = {3, 0.7, boundary, 1e5, -2};
        request.count = 300;
        request.mode = Mode::pixels;
        request.on_pixels = {30, 20};
        request.field = &kField;
        Result result = sample(request);
        EXPECT_NEAR(result.radius, 0.035, 1e-9);
        EXPECT_TRUE(prove(result.points, claim_of(request, result)).kept);
        result.points[7] = result.points[8];
        EXPECT_FALSE(prove(result.points, claim_of(request, result)).kept);
    }
}

}  // namespace
}  // namespace lacuna
