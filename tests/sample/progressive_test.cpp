// Progressive orders: every prefix is as even as a set of its own size. That every level is maximal
// is judged by hostile.
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

namespace lacuna {
namespace progressive_test {

Request progressive(std::uint64_t count, std::uint64_t seed = 0) {
    Request request;
    request.progressive = true;
    request.domain.boundary = Boundary::torus;
    request.count = count;
    request.seed = seed;
    return request;
}

TEST(Progressive, IsEvenAtEveryPrefix) {
    double sum = 0;
    std::size_t prefixes = 0;
    for (const std::uint64_t seed : {0U, 1U, 2U, 3U}) {
        const Request request = progressive(2048, seed);
        const std::vector<double> relative =
            judge::relative_distances(request.domain, sample(request).points);
        for (std::size_t i = 14; i < relative.size(); ++i) {
            ASSERT_GE(relative[i], 0.70) << i + 2 << " points of seed " << seed;
            sum += relative[i];
            ++prefixes;
        }
    }
    EXPECT_GE(sum / static_cast<double>(prefixes), 0.74);
}

const std::vector<Point> kKeep{{0.5, 0.5}, {0.53, 0.5}, {0.9, 0.2}};

TEST(Progressive, HasKeptPointsFirst) {
    Request request;
    request.progressive = true;
    request.radius = 0.025;
    request.keep = kKeep;
    const Result result = sample(request);
    EXPECT_TRUE(std::equal(kKeep.begin(), kKeep.end(), result.points.begin()));
    EXPECT_GE(result.levels.size(), 9U);
    // Levels begin where the kept points, 0.03 apart, are not too close together.
    EXPECT_LE(result.levels.front().size, 0.03);
    request.radius = 0.05;
    const std::string refusal = tests::refusal_of([&] { sample(request); });
    EXPECT_TRUE(refusal.starts_with("keep point 0")) << refusal;
    EXPECT_NE(refusal.find("at least 0.05"), std::string::npos) << refusal;
    // On the same place points are too close at any radius.
    const std::vector<Point> twice{{0.5, 0.5}, {0.5, 0.5}};
    Request counted = progressive(50);
    counted.keep = twice;
    EXPECT_TRUE(tests::refusal_of([&] { sample(counted); }).starts_with("keep point 0"));
}

TEST(Progressive, EndsWithExactlyTheRadiusThatWasAskedFor) {
    Request request;
    request.progressive = true;
    for (int i = 0; i < 30; ++i) {
        request.radius = 0.05 + 0.0017 * i;
        EXPECT_EQ(sample(request).radius, *request.radius);
    }
}

// At the radius of 16 points the ellipses would be longer than the torus.
TEST(Progressive, BeginsAtALevelWhereEllipsesFitOnATorus) {
    const Field field = tests::swirled(tests::constant_field(12, 12), 25);
    Request request = progressive(1);
    request.count.reset();
    request.field = &field;
    request.scale = 0.09;
    const Result result = sample(request);
    EXPECT_TRUE(result.maximal);
    EXPECT_LE(result.levels.front().size, 0.1);
    EXPECT_EQ(judge::Judge(request, result).fault(), "");
}

TEST(Progressive, IsCutWithinKeptPoints) {
    Request request = progressive(2);
    request.keep = kKeep;
    EXPECT_EQ(sample(request).points, (std::vector<Point>{kKeep[0], kKeep[1]}));
}

TEST(Progressive, IsRefusedAtOnceWhereItWouldTakeTooMuch) {
    Request request = progressive(1'000'000'000'000);
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("count 1000000000000: "));
    request = progressive(2'000'000);
    request.run_on.memory_limit_bytes = 100'000'000;
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("count 2000000: needs"));
    request.count.reset();
    request.radius = 1e-9;
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("radius 1e-09: makes"));
    request.radius = -1;
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("radius -1: must be"));
}

}  // namespace progressive_test
}  // namespace lacuna
