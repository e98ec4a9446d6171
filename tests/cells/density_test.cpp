// How many samples mode cells places: on constant fields, on both sides of a step in importance,
// and along its edge. docs/cells.md has the tables that these tests print.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <tuple>

#include "fields.h"

namespace {

using namespace lacuna;

// docs/design.md, section 5: N r^2 of a maximal set on the torus.
constexpr double kJamming = 0.69656;

struct Mean {
    double value;
    double error;  // standard error
};

template <typename Of>
Mean mean_over(int seeds, Of of) {
    double sum = 0;
    double squares = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const double value = of(static_cast<std::uint64_t>(seed));
        sum += value;
        squares += value * value;
    }
    const double mean = sum / seeds;
    return {mean, std::sqrt(std::max(0.0, squares / seeds - mean * mean) / (seeds - 1))};
}

Request torus_request(const Field& field, double scale, std::uint32_t m) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale = scale;
    request.domain.boundary = Boundary::torus;
    request.paper2011.lines_per_radius = m;
    return request;
}

struct Loss {
    std::uint32_t m;
    double least;  // N r^2, and the band that a mean must lie in
    double most;
};

// At 30 steps within 1.5 % of uniform. N r^2 of a constant field, over radii whose multiples lie
// differently on the lattice. Means of 40 sets of about 1,700 lie within 0.002.
constexpr Loss kLosses[] = {{3, 0.59, 0.605},    {4, 0.64, 0.66},    {5, 0.62, 0.64},
                            {7, 0.67, 0.69},     {10, 0.655, 0.672}, {20, 0.675, 0.69},
                            {30, 0.6862, 0.697}, {40, 0.685, 0.697}};

TEST(CellsDensity, AConstantFieldLosesToTheLatticeWhatItsStepsTell) {
    std::printf("| m | N r^2 | standard error | less than %.5f by |\n", kJamming);
    for (const Loss& loss : kLosses) {
        const Field field = tests::constant_field(3, 2, 0.7);
        const Mean mean = mean_over(40, [&](std::uint64_t seed) {
            const double radius = 0.02 + 0.0001 * static_cast<double>(seed % 20);
            Request request = torus_request(field, radius * std::sqrt(0.7), loss.m);
            request.seed = seed;
            return static_cast<double>(sample(request).points.size()) * radius * radius;
        });
        std::printf("| %u | %.4f | %.4f | %.1f %% |\n", loss.m, mean.value, mean.error,
                    100 * (1 - mean.value / kJamming));
        EXPECT_GT(mean.value, loss.least) << loss.m;
        EXPECT_LT(mean.value, loss.most) << loss.m;
    }
}

// Importance 1 on the left half, 1/10 on the right, on a torus twice as wide as high: two edges.
constexpr double kDenseRadius = 0.012;
constexpr double kSparseRadius = 0.012 * 3.1622776601683795;
constexpr int kSeeds = 20;

// Bands along an edge, in dense radii: [0, 1/2), [1/2, 1), [1, 2), up to the sparse radius, and the
// same in sparse radii on the other side.
constexpr std::array<double, 4> kBands = {0.5, 1, 2, 3.1622776601683795};

// Samples per unit of area.
struct Side {
    double away = 0;                // away from the edges
    std::array<double, 4> bands{};  // beside an edge
};

struct Profile {
    Side dense;
    Side sparse;
};

void note(Side& side, double to_edge, double radius) {
    if (to_edge > 4 * kSparseRadius) ++side.away;
    for (std::size_t i = 0; i < kBands.size(); ++i) {
        if (to_edge >= kBands[i] * radius) continue;
        ++side.bands[i];
        break;
    }
}

void divide(Side& side, double radius) {
    side.away /= kSeeds * (1 - 8 * kSparseRadius);
    double begin = 0;
    for (std::size_t i = 0; i < kBands.size(); ++i) {
        side.bands[i] /= kSeeds * 2 * (kBands[i] - begin) * radius;
        begin = kBands[i];
    }
}

Profile profile(Metric metric, std::uint32_t m) {
    const Field field = tests::step_field(2, 1);
    Request request = torus_request(field, kDenseRadius, m);
    request.domain.width = 2;
    request.metric = metric;
    Profile found;
    for (request.seed = 0; request.seed < kSeeds; ++request.seed) {
        for (const Point point : sample(request).points) {
            const bool is_dense = point.x < 1;
            const double in_half = is_dense ? point.x : point.x - 1;
            note(is_dense ? found.dense : found.sparse, std::min(in_half, 1 - in_half),
                 is_dense ? kDenseRadius : kSparseRadius);
        }
    }
    divide(found.dense, kDenseRadius);
    divide(found.sparse, kSparseRadius);
    return found;
}

// Samples missing in the first two bands, per radius of edge; negative: there are too many.
double missing_within_a_radius(const Side& side, double radius) {
    return (side.away - (side.bands[0] + side.bands[1]) / 2) * radius * radius;
}

TEST(CellsDensity, AStepOfTenToOneGivesTenTimesTheSamplesWithEveryMetric) {
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        const Profile found = profile(metric, 30);
        std::printf("%s: %.3f : 1 away from the edge\n", name_of(metric).data(),
                    found.dense.away / found.sparse.away);
        EXPECT_NEAR(found.dense.away / found.sparse.away, 10, 0.2);
    }
}

// Figures 2, 6 and 8 of the paper, as numbers.
TEST(CellsDensity, MaxCutsOutSamplesAlongTheEdgeMeanFewerAndMinNone) {
    std::printf("| metric | side | density in bands | missing samples per radius of edge |\n");
    std::array<double, 3> missing{};
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        const Profile found = profile(metric, 10);
        missing[static_cast<std::size_t>(metric)] =
            missing_within_a_radius(found.dense, kDenseRadius);
        for (const auto& [name, side, radius] :
             {std::tuple("dense", &found.dense, kDenseRadius),
              std::tuple("sparse", &found.sparse, kSparseRadius)}) {
            std::printf("| %s | %s |", name_of(metric).data(), name);
            for (const double band : side->bands)
                std::printf(" %+.0f %% |", 100 * (band / side->away - 1));
            std::printf(" %+.3f |\n", missing_within_a_radius(*side, radius));
        }
    }
    EXPECT_LT(missing[0], 0);
    EXPECT_NEAR(missing[1], 0.02, 0.03);
    EXPECT_GT(missing[2], 0.15);
}

}  // namespace
