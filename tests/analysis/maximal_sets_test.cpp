// Given maximal Poisson-disk sets, all numbers agree with docs/design.md, section 5.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/analyse.h"
#include "analysis/maximal.h"
#include "analysis/sets.h"

namespace lacuna::analysis {
namespace maximal_sets_test {

constexpr double kRadius = 0.01;
constexpr std::uint64_t kSets = 10;

struct Known {
    double frequency;
    double power;
};
// The radial mean of ten exact sets. Ten others scatter by 1 to 2 % around it.
constexpr std::array<Known, 8> kKnown{{{0.5, 0.092},
                                       {0.7, 0.235},
                                       {0.9, 0.888},
                                       {1.0, 1.418},
                                       {1.1, 1.695},
                                       {1.3, 1.371},
                                       {1.5, 0.878},
                                       {2.0, 0.872}}};

Analysis analysis_of(const Sets& sets) {
    const std::vector<std::optional<double>> radii(sets.size(), kRadius);
    return analyse(sets, {1, 1, true}, radii, carry_on);
}

void expect_known_spectrum(const Analysis& analysis, double tolerance) {
    for (const Known& known : kKnown)
        EXPECT_NEAR(analysis.radial.at(known.frequency).power, known.power, tolerance * known.power)
            << "at " << known.frequency;
    EXPECT_NEAR(analysis.radial.peak().power, 1.77, tolerance * 1.77);
    EXPECT_NEAR(analysis.radial.peak().frequency, 1.13, 0.05);
    EXPECT_NEAR(analysis.radial.mean_anisotropy_db().value(), -10, 0.3);
}

// Made by this test's own sampler, which has no code in common with Lacuna's.
TEST(MaximalSets, HaveTheKnownNumbers) {
    Sets sets;
    for (std::uint64_t seed = 0; seed < kSets; ++seed) sets.push_back(maximal_set(kRadius, seed));
    const Analysis analysis = analysis_of(sets);
    expect_known_spectrum(analysis, 0.05);
    // 0.244 sqrt(N) is 0.29 % of the count; the tolerance is five times that for the mean of ten.
    EXPECT_NEAR(analysis.count_times_squared_radius.value(), 0.69656, 0.0032);
    EXPECT_NEAR(analysis.distances->mean / kRadius, 1.0538, 0.0015);
    EXPECT_GE(analysis.distances->least, kRadius);
    // About 5.6 near contact, where g falls steeply: its mean over 2 % depends on where it ends.
    EXPECT_NEAR(analysis.distances->contact.value(), 5.5, 0.2);
    EXPECT_NEAR(analysis.vertical_line->ratio, 1, 0.13);  // 5 / sqrt(167 * 10)
    EXPECT_NEAR(analysis.horizontal_line->ratio, 1, 0.13);
}

// Exact sets. The paper's lines, which interpolate x and are not quite maximal, are 6 % over the
// known power at 0.5.
TEST(SampledSets, HaveTheKnownSpectrum) {
    Sets sets;
    Request request;
    request.radius = kRadius;
    request.domain.boundary = Boundary::torus;
    for (request.seed = 0; request.seed < kSets; ++request.seed)
        sets.push_back(sample(request).points);
    expect_known_spectrum(analysis_of(sets), 0.05);
}

TEST(Analyse, OfOnePointKnowsWhatOnePointHas) {
    const Analysis analysis = analyse(Sets{{{0.5, 0.5}}}, {1, 1, true}, {}, carry_on);
    EXPECT_EQ(analysis.counts.mean, 1);
    EXPECT_FALSE(analysis.distances);
    EXPECT_FALSE(analysis.bond_order);
    EXPECT_FALSE(analysis.radius);
    EXPECT_NEAR(analysis.radial.peak().power, 1, 1e-12);
}

TEST(Analyse, KnowsNoRadiusUnlessEverySetHasOne) {
    const Sets sets{white_noise(50, {1, 1, true}, 1), white_noise(50, {1, 1, true}, 2)};
    const std::vector<std::optional<double>> some{0.01, std::nullopt};
    EXPECT_FALSE(analyse(sets, {1, 1, true}, some, carry_on).count_times_squared_radius);
    const std::vector<std::optional<double>> both{0.1, 0.2};
    const Analysis analysis = analyse(sets, {1, 1, true}, both, carry_on);
    EXPECT_NEAR(analysis.radius.value(), 0.15, 1e-12);
    EXPECT_NEAR(analysis.count_times_squared_radius.value(), 50 * (0.01 + 0.04) / 2, 1e-12);
}

TEST(Analyse, RefusesDomainsAndRadiiThatMakeNoSense) {
    const Sets sets{white_noise(5, {1, 1, true}, 1)};
    EXPECT_THROW(analyse(sets, {0, 1, true}, {}, carry_on), BadRequest);
    EXPECT_THROW(analyse(sets, {1, 2000, true}, {}, carry_on), BadRequest);
    const std::vector<std::optional<double>> negative{-0.01};
    EXPECT_THROW(analyse(sets, {1, 1, true}, negative, carry_on), BadRequest);
}

}  // namespace maximal_sets_test
}  // namespace lacuna::analysis
