// claim_of: every set keeps what it promises, and a set that breaks it is refuted.
#include <gtest/gtest.h>
#include <lacuna/verify.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

const Field kField{2, 1, {1, 0.25}};
const Mask kMask{2, 2, {1, 1, 0, 1}};
const std::vector<Point> kKept{{0.75, 0.75}, {0.25, 0.75}};

using Change = std::function<void(Request&)>;

void check_promise(const Change& change, bool promises_no_gaps) {
    Request request;
    request.radius = 0.05;
    change(request);
    const Result result = sample(request);
    const Claim claim = claim_of(request, result);
    EXPECT_EQ(claim.distances_only, !promises_no_gaps);
    const Proof proof = prove(result.points, claim);
    EXPECT_TRUE(proof.kept) << proof.least_distance << " " << proof.least_limit;
    EXPECT_EQ(proof.maximal, promises_no_gaps);
    std::vector<Point> points = result.points;
    points.back() = points[points.size() / 2];
    EXPECT_FALSE(prove(points, claim).kept);
    if (!promises_no_gaps || !claim.classes.names.empty()) return;
    points.pop_back();
    EXPECT_FALSE(prove(points, claim).covered);
}

TEST(Claims, OfMaximalSetsAreDistancesAndNoGaps) {
    const std::vector<Change> all{
        [](Request&) {},
        [](Request& request) { request.domain.boundary = Boundary::torus; },
        [](Request& request) { request.domain.height = 0.5; },
        [](Request& request) {
            request.radius.reset();
            request.scale = 0.04;
            request.field = &kField;
        },
        [](Request& request) {
            request.mask = &kMask;
            request.border = 0.1;
            request.keep = kKept;
        },
        [](Request& request) {
            request.radius.reset();
            request.classes = {{"a", "b"}, {0.2, 0.1, 0.1, 0.05}, {}};
        }};
    for (const Change& one : all) check_promise(one, true);
}

TEST(Claims, OfOtherSetsAreDistances) {
    const std::vector<Change> all{[](Request& request) { request.limit = 30; },
                                  [](Request& request) {
                                      request.radius.reset();
                                      request.count = 200;
                                  },
                                  [](Request& request) { request.mode = Mode::lines; },
                                  [](Request& request) {
                                      request.mode = Mode::lines;
                                      request.paper2011.snap = true;
                                  },
                                  [](Request& request) {
                                      request.radius.reset();
                                      request.scale = 0.04;
                                      request.field = &kField;
                                      request.mode = Mode::cells;
                                  }};
    for (const Change& one : all) check_promise(one, false);
}

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
