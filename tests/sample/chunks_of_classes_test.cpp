// Chunks whose classes have borders and masks of their own, beside kept points outside.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "backends/radius_field_requests.h"
#include "refusal.h"
#include "sample/chunk_requests.h"

namespace chunks_of_classes_test {

using namespace lacuna;

// Classes with borders and masks of their own, beside points outside of all classes.
TEST(ChunksOfClasses, WithPlacesOfTheirOwnAreProvenAndEqualTheReference) {
    std::mt19937_64 random(1871);
    const auto in = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::size_t neighbours = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
        Request request = tests::chunk_of_classes();
        Domain& domain = request.domain;
        domain.width = in(0.4, 1);
        domain.height = in(0.4, 1);
        if (i % 3 == 0) domain.x0 = in(-1e4, 1e4);
        Request ring = request;
        ring.domain = {domain.width + 0.6, domain.height + 0.6, Boundary::box, domain.x0 - 0.3,
                       domain.y0 - 0.3};
        ring.seed = random();
        const Result around = sample(ring);
        std::vector<Point> keep;
        std::vector<std::uint8_t> keep_classes;
        for (std::size_t j = 0; j < around.points.size(); ++j) {
            if (domain.holds(around.points[j]) || random() % 3 == 0) continue;
            keep.push_back(around.points[j]);
            keep_classes.push_back(around.classes[j]);
        }
        const std::uint32_t columns = 1 + i % 80, rows = 2 + i % 7;
        const Mask chess = tests::chess_mask(columns, rows);
        const Mask noise = tests::noise_mask(columns, rows, random());
        if (i % 4 != 0) request.classes.masks = {&noise, nullptr, &chess};
        if (i % 8 == 1) request.mask = &noise;
        if (i % 4 != 1) request.classes.borders = {in(0, 0.15), 0, in(0, 0.1)};
        request.keep = keep;
        request.keep_classes = keep_classes;
        request.seed = random();
        const Result set = sample(request);
        neighbours += keep.size();
        const Proof proof = prove(set.points, claim_of(request, set));
        EXPECT_TRUE(proof.maximal)
            << i << ": gap " << proof.largest_gap_distance - proof.largest_gap_limit;
        if (i % 10 != 1) continue;
        request.place.backend = "reference";
        EXPECT_EQ(sample(request).points, set.points) << i;
    }
    EXPECT_GT(neighbours, 1000U);
}

// The widest class keeps its border from the edges of the request's domain, wherever the points
// outside are.
TEST(ChunksOfClasses, MeasureBordersFromTheirOwnEdges) {
    Request request = tests::chunk_of_classes();
    request.classes.borders = {0.2, 0.1, 0};
    const std::vector<Point> keep{{-0.01, 0.5}, {0.5, 1.1}};
    const std::vector<std::uint8_t> keep_classes{2, 0};
    request.keep = keep;
    request.keep_classes = keep_classes;
    const Result set = sample(request);
    std::array<double, 3> least{1, 1, 1};
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Point at = set.points[i];
        double& own = least[set.classes[i]];
        own = std::min({own, at.x, at.y, 1 - at.x, 1 - at.y});
    }
    for (std::size_t kind = 0; kind < 3; ++kind) {
        EXPECT_GE(least[kind], request.classes.borders[kind]) << kind;
        EXPECT_LT(least[kind], request.classes.borders[kind] + 0.02) << kind;
    }
}

// The domain, or a pixel of its mask, would have no unit of the grid that it shares with the points
// outside.
TEST(ChunksOfClasses, RefuseDistancesFarBeyondTheDomain) {
    const auto refusal = [](double far, const Mask* mask) {
        Request request;
        request.classes.names = {"trees", "grass"};
        request.classes.distances = {2 * far, far, far, far / 1000};
        request.border = 0.3;
        request.mask = mask;
        const std::vector<Point> keep{{-far, 0.5}};
        const std::vector<std::uint8_t> keep_classes{0};
        request.keep = keep;
        request.keep_classes = keep_classes;
        return tests::refusal_of([&] { sample(request); });
    };
    const std::string begin = " outside: is within the greatest distance, but with it the domain ";
    const std::string end =
        " long: 2^20 times its shorter side, and 2^30 pixels of a mask or of "
        "polygons";
    EXPECT_EQ(refusal(1e6, nullptr), "accepted");
    EXPECT_EQ(refusal(1e9, nullptr), "keep a point 1e+09" + begin + "may be at most 1048576" + end);
    EXPECT_EQ(refusal(1e10, nullptr),
              "keep a point 1e+10" + begin + "may be at most 1048576" + end);
    const Mask fine{65536, 1, std::vector<std::uint8_t>(65536, 1)};
    EXPECT_EQ(refusal(1e4, &fine), "accepted");
    EXPECT_EQ(refusal(1e5, &fine), "keep a point 1e+05" + begin + "may be at most 16384" + end);
}

}  // namespace chunks_of_classes_test
