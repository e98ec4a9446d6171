// Sets with a radius field have the right counts and the right distribution: the jamming limit on a
// constant field and on each side of a step; and any prefix is distributed as dart throwing's with
// the same field. Admission in spatial order is noticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "distribution/statistics.h"
#include "fields.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "portable/distance.h"
#include "rounds/random.h"
#include "sampling/generate.h"

namespace {

using namespace lacuna;

constexpr double kJammed = 0.69656;  // N r^2 on the torus

#ifdef LACUNA_SPATIAL_ORDER
constexpr bool kIsRight = false;
#else
constexpr bool kIsRight = true;
#endif

Request request_of(const Field& field, double scale, double width = 1) {
    Request request;
    request.field = &field;
    request.scale = scale;
    request.width = width;
    request.boundary = Boundary::torus;
    request.backend = "cpu";
    return request;
}

std::vector<Sample> samples_of(const Request& request, const Plan& plan) {
    Observer nobody;
    return run_on_backend(request, plan, nobody).outcome.samples;
}

#ifndef LACUNA_SPATIAL_ORDER

TEST(AConstantField, HasAsManySamplesAsAUniformSet) {
    const Field field = tests::constant_field(8, 8, 3);
    constexpr double kRadius = 0.01;
    Request request = request_of(field, kRadius * std::sqrt(3.0));
    std::vector<double> densities;
    for (request.seed = 0; request.seed < 100; ++request.seed)
        densities.push_back(static_cast<double>(samples_of(request, make_plan(request)).size()) *
                            kRadius * kRadius);
    const tests::Mean mean = tests::mean_of(densities);
    const double z = (mean.value - kJammed) / mean.error;
    std::printf("N r^2 = %.5f +- %.5f, z %+.2f\n", mean.value, mean.error, z);
    EXPECT_LT(std::abs(z), 3);
}

// Counts start five of the larger radii away from the step.
TEST(AStep, HasTheDensityOfEachSideOnThatSide) {
    const Field field = tests::step_field(2, 1, 4);
    constexpr double kRadius = 0.01;
    Request request = request_of(field, kRadius, 2);
    std::vector<double> dense;
    std::vector<double> sparse;
    for (request.seed = 0; request.seed < 60; ++request.seed) {
        const Plan plan = make_plan(request);
        double left = 0;
        double right = 0;
        for (const Sample sample : samples_of(request, plan)) {
            const double x = plan.to_user(sample).x;
            left += x > 0.1 && x < 0.9 ? 1 : 0;
            right += x > 1.1 && x < 1.9 ? 1 : 0;
        }
        dense.push_back(left * kRadius * kRadius / 0.8);
        sparse.push_back(right * 4 * kRadius * kRadius / 0.8);
    }
    for (const std::vector<double>& side : {dense, sparse}) {
        const tests::Mean mean = tests::mean_of(side);
        std::printf("density %.5f +- %.5f\n", mean.value, mean.error);
        EXPECT_LT(std::abs(mean.value - kJammed), std::max(0.002 * kJammed, 3 * mean.error));
    }
}

#endif

// Uniform darts, each compared with all accepted ones.
std::vector<Sample> throw_darts(const Request& request, const Plan& plan) {
    std::vector<Sample> stuck;
    std::vector<std::uint64_t> radii;
    for (std::uint64_t number = 0; stuck.size() < plan.limit; ++number) {
        const RandomBits random = random_bits(request.seed, number);
        const Sample dart{static_cast<std::uint32_t>(scaled(random.first, plan.width)),
                          static_cast<std::uint32_t>(scaled(random.second, plan.height))};
        const std::uint64_t radius = plan.field().radius_field->radius_at(dart.x, dart.y);
        bool is_free = radius != 0;
        for (std::size_t i = 0; i < stuck.size() && is_free; ++i) {
            const std::uint64_t least = std::min(radius, radii[i]);
            is_free = !portable::are_closer(stuck[i].x, stuck[i].y, dart.x, dart.y, plan.period_x,
                                            plan.period_y, least * least);
        }
        if (!is_free) continue;
        stuck.push_back(dart);
        radii.push_back(radius);
    }
    return stuck;
}

template <typename Make>
tests::Sets make_sets(Request request, std::uint64_t first_seed, Make make) {
    constexpr std::uint64_t kSeeds = 100;
    tests::Sets sets;
    for (request.seed = first_seed; request.seed < first_seed + kSeeds; ++request.seed) {
        const Plan plan = make_plan(request);
        const std::vector<Sample> samples = make(request, plan);
        const auto on_the_left =
            std::count_if(samples.begin(), samples.end(),
                          [&](const Sample& sample) { return sample.x < plan.width / 2; });
        sets.add(plan, samples, static_cast<std::size_t>(on_the_left));
    }
    return sets;
}

TEST(SetsOnAStep, AreDistributedAsDartThrowings) {
    const Field field = tests::step_field(2, 1, 4);
    constexpr double kRadius = 0.02;
    Request request = request_of(field, kRadius);
    // About four fifths of the maximal count.
    request.limit = static_cast<std::uint64_t>(0.8 * kJammed * 0.625 / (kRadius * kRadius));
    // Rounds larger than Lacuna would choose make a sharper test.
    request.round_size = 3000;
    const tests::Verdict verdict =
        compare(make_sets(request, 1000, throw_darts), make_sets(request, 2000, samples_of));
    std::printf("%s: %s\n", LACUNA_VARIANT, verdict.text().c_str());
    EXPECT_EQ(verdict.same(), kIsRight);
}

}  // namespace
