// The promises of lacuna.h for mode exact with a field, a mask, a border and kept points, seen from
// outside: distances and room in double, the kept points.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "backends/radius_field_requests.h"
#include "judge/judge.h"
#include "refusal.h"

namespace {

using namespace lacuna;
using tests::FieldRequest;

void expect_that_promises_are_kept(const FieldRequest& made, const Result& result) {
    const judge::Judge judge(made.request, result);
    EXPECT_EQ(judge.fault(), "");
    if (!result.maximal) return;
    judge::Random random(11);
    const judge::Judge::Gap gap = judge.largest_gap(random);
    EXPECT_LE(gap.room, judge.tolerance()) << "(" << gap.at.x << ", " << gap.at.y << ")";
}

TEST(ASetWithARadiusField, KeepsWhatIsPromisedOnEveryKindOfRequest) {
    for (FieldRequest made : tests::radius_field_requests()) {
        SCOPED_TRACE(made.name);
        if (made.name.find("threads share") != std::string::npos) continue;  // too many for pairs
        made.request.run_on.backend = "cpu";
        const Result result = sample(made.request);
        EXPECT_EQ(result.maximal, !made.request.limit);
        expect_that_promises_are_kept(made, result);
    }
}

// The middle of the only row of the mask lies where the field is 0.
TEST(ASetWithARadiusField, OfACountOnAMaskThatIsCoarserThanTheField) {
    const Field field{1, 3, {1, 0, 0.5}};
    Mask mask{4, 1, {1, 0, 1, 1}};
    Request request;
    request.field = &field;
    request.places.mask = &mask;
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
            made.request.places.mask = &left;
        }
        std::vector<Point> beside;
        for (const double y : {0.1, 0.3, 0.5, 0.7, 0.9}) beside.push_back({0.5 + 0x1.8p-29, y});
        made = with_keep(made, beside);
        const Result result = sample(made.request);
        Claim claim;
        claim.radius = claim.scale = 0.1;
        claim.field = made.request.field;
        claim.places.mask = made.request.places.mask;
        claim.keep = beside;
        const Proof proof = prove(result.points, claim);
        EXPECT_GE(proof.least_distance, 0.1) << proof.first << " and " << proof.second;
        EXPECT_TRUE(proof.maximal);
    }
}

}  // namespace
