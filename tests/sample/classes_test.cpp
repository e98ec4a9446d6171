// Classes of points, seen from outside: what is kept, limited and counted.
// Distances and room are judged by hostile.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backends/radius_field_requests.h"
#include "judge/judge.h"
#include "refusal.h"

namespace {

using namespace lacuna;

Request request_of(std::vector<double> distances, std::vector<double> weights = {}) {
    Request request;
    const auto count = static_cast<std::size_t>(std::lround(std::sqrt(distances.size())));
    for (std::size_t i = 0; i < count; ++i)
        request.classes.names.push_back("class-" + std::to_string(i));
    request.classes.distances = std::move(distances);
    request.classes.weights = std::move(weights);
    request.run_on.backend = "cpu";
    return request;
}

TEST(Classes, KeepByUnionTheRadiusOfEachAndTheDistanceOfAll) {
    const std::vector<double> radii{0.04, 0.02, 0.01};
    const std::vector<double> distances = distances_by_union(radii);
    EXPECT_DOUBLE_EQ(distances[0], 0.04);
    EXPECT_DOUBLE_EQ(distances[1], 1 / std::sqrt(1 / 0.0016 + 1 / 0.0004));
    EXPECT_DOUBLE_EQ(distances[2], 1 / std::sqrt(1 / 0.0016 + 1 / 0.0004 + 1 / 0.0001));
    EXPECT_DOUBLE_EQ(distances[5], distances[2]);
    EXPECT_EQ(distances[8], 0.01);
    EXPECT_EQ(distances_by_sum(radii),
              (std::vector<double>{0.08, 0.06, 0.05, 0.06, 0.04, 0.03, 0.05, 0.03, 0.02}));

    // The points of each class, as a share of a set of its own: 0.73, 0.70 and 0.86 in 40 sets.
    Request request = request_of(distances);
    request.domain.boundary = Boundary::torus;
    std::vector<double> counts(3);
    constexpr int kSets = 8;
    for (request.seed = 0; request.seed < kSets; ++request.seed)
        for (const std::uint8_t one : sample(request).classes) counts[one] += 1.0 / kSets;
    for (std::size_t i = 0; i < 3; ++i) {
        const double alone = expected_count({1, 1, Boundary::torus}, radii[i]);
        EXPECT_GT(counts[i], 0.65 * alone) << i;
        EXPECT_LT(counts[i], 0.95 * alone) << i;
    }
}

// A class with a weight has more points at first; the one that is drawn more often wins more room.
TEST(Classes, AreDrawnByTheirWeights) {
    const std::vector<double> same{0.02, 0.02, 0.02, 0.02};
    std::vector<double> shares;
    for (const double weight : {1.0, 9.0}) {
        Request request = request_of(same, {1, weight});
        request.domain.boundary = Boundary::torus;
        double second = 0, all = 0;
        for (request.seed = 0; request.seed < 20; ++request.seed) {
            const Result result = sample(request);
            second += static_cast<double>(
                std::count(result.classes.begin(), result.classes.end(), std::uint8_t{1}));
            all += static_cast<double>(result.points.size());
        }
        shares.push_back(second / all);
    }
    // Every free place is free for both classes, so their shares are those of the weights. With
    // 34,000 points a share has a standard deviation of 0.003.
    EXPECT_NEAR(shares[0], 0.5, 0.01);
    EXPECT_NEAR(shares[1], 0.9, 0.01);
}

TEST(Classes, RefuseKeptPointsWithinTheirBorderAndOffTheirMask) {
    Request request = request_of({0.1, 0.1, 0.1, 0.1});
    request.places.borders = {0, 0.2};
    const std::vector<Point> keep{{0.1, 0.5}};
    request.keep = keep;
    const std::vector<std::uint8_t> near{0}, far{1};
    request.keep_classes = near;
    const Result made = sample(request);
    EXPECT_EQ(made.points.front(), keep.front());
    EXPECT_TRUE(prove(made.points, claim_of(request, made)).maximal);
    request.keep_classes = far;
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "keep point 0 at (0.1, 0.5): must be at least the border, 0.2, from the domain's "
              "edges");
    const Mask right{2, 1, {0, 1}};
    request.places.borders = {};
    request.places.masks = {nullptr, &right};
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "keep point 0 at (0.1, 0.5): must lie where the mask is not 0");
}

// Its trial has 10 points, as many as are counted.
TEST(Classes, ThatALimitCutsAreNotMaximal) {
    Request request = request_of(distances_by_sum(std::vector{2.0, 1.0}));
    request.domain.boundary = Boundary::torus;
    request.count = 10;
    request.seed = 9;
    EXPECT_TRUE(sample(request).maximal);
    request.limit = 3;
    EXPECT_FALSE(sample(request).maximal);
}

// Both sets had a gap when factors were multiples of 2^-20.
TEST(Classes, OfNearlyEqualDistancesHaveNoGap) {
    const auto expect_maximal = [](const Request& request) {
        const Result result = sample(request);
        std::vector<Level> levels = result.levels;
        if (levels.empty())
            levels.push_back({.size = result.radius, .points = result.points.size()});
        for (const Level& level : levels) {
            Claim claim = claim_of(request, result);
            claim.radius = level.size;
            claim.class_of_points = std::span(result.classes).first(level.points);
            EXPECT_TRUE(prove(std::span(result.points).first(level.points), claim).maximal)
                << "the first " << level.points << " points";
        }
    };
    Request request = request_of({0.0125, 0, 0, 0.0125000001}, {0, 1});
    request.seed = 361;
    expect_maximal(request);

    Request kept = request_of({0.0784234, 0, 0, 0.0800121}, {10.048, 1});
    kept.domain = {2, 1, Boundary::box, -1.03346, -1.52815};
    kept.seed = 3;
    kept.progressive = true;
    const std::vector<Point> points{
        {-0.22078409421672163, -1.2822522054372327}, {0.7200864392866022, -1.3578799298998636},
        {0.24694092124091727, -0.9220212819496469},  {0.6789476574260509, -1.510053583760636},
        {-0.773803663858833, -1.3482805132074076},   {0.16286339381474813, -1.4892224403742231},
        {-0.06658375949314199, -1.4599508226114677}, {0.18578339403699173, -0.9983482020509123},
        {0.5448985891684, -1.3425608606882427},      {-0.4696536177827457, -1.280871277630996},
        {0.7011661202429806, -1.1178869218070855},   {0.1528872567321733, -1.1375488682990473},
        {-0.40054063232828496, -1.0163695560226707}, {0.5183872306334327, -1.407787547997882},
        {0.4138083872354672, -0.6124407044485871},   {-0.06521636846291967, -1.309741473544562},
        {0.9125550095647084, -1.1674558040175993},   {0.4248193272434144, -0.5579308655192182},
        {0.380309685717805, -0.8414596672658181},    {-0.49383263333767147, -1.0066083929769691},
        {-0.3359719204609066, -0.6755719001658819}};
    const std::vector<std::uint8_t> classes{1, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0,
                                            0, 1, 0, 0, 0, 1, 1, 0, 1, 0};
    kept.keep = points;
    kept.keep_classes = classes;
    expect_maximal(kept);
}

}  // namespace
