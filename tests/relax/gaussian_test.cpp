// The descent of the Gaussian energy: the same spots on every backend, and what it is for: no power
// at low frequencies, and a least distance.
#include <gtest/gtest.h>

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "fields.h"
#include "judge/plane.h"
#include "refusal.h"
#include "relax/available.h"
#include "relax/cpu/gaussian.h"
#include "relax/gaussian.h"
#include "relax/relax_backends.h"
#include "relax/scenes.h"

namespace lacuna::relaxing::tests {
namespace {

using lacuna::tests::refusal_of;

// Points without a picture; also on domains so narrow that a sample is in reach of many images.
std::vector<Scene> gaussian_scenes() {
    std::vector<Scene> all;
    for (const Scene& scene : scenes())
        if (!scene.field) all.push_back(scene);
    all.push_back(
        {"a thousand on a torus", random_points(1000, 2, 1, 20), {}, on(2, 1, Boundary::torus)});
    all.push_back({"some in a box", random_points(333, 1, 2, 21), {}, on(1, 2, Boundary::box)});
    all.push_back(
        {"two on a thread", random_points(2, 900, 1, 22), {}, on(900, 1, Boundary::torus)});
    return all;
}

std::vector<Spot> descended(GaussianBackend& backend, std::uint32_t steps) {
    for (std::uint32_t step = 0; step < steps; ++step) backend.descend(gaussian_pace(step));
    return backend.spots();
}

class Gaussian : public OnBackend {};
INSTANTIATE_TEST_SUITE_P(All, Gaussian, kRelaxBackends, name_of_parameter);

TEST_P(Gaussian, gives_the_spots_of_the_reference) {
    constexpr std::uint32_t kSteps = 6;
    for (const Scene& scene : gaussian_scenes()) {
        RelaxOptions options = scene.options;
        options.gaussian = kSteps;
        const GaussianField field = make_gaussian(scene.points.size(), options);
        const std::vector<Spot> start = spots_of(scene.points, field, options, nobody_asks);
        options.run_on.backend = "reference";
        const auto reference = make_gaussian_backend(options.run_on, field, start).backend;
        options.run_on.backend = GetParam();
        const auto backend = make_gaussian_backend(options.run_on, field, start).backend;
        EXPECT_TRUE(descended(*reference, kSteps) == descended(*backend, kSteps)) << scene;
    }
}

TEST_P(Gaussian, is_asked_whether_to_go_on_in_each_step) {
    class Stop : public Observer {
    public:
        bool keep_going(const Progress& progress) override {
            EXPECT_EQ(progress.expected_points, 500u * 23);
            return (rounds = progress.rounds) < 7;
        }
        std::uint64_t rounds = 0;
    } stop;
    RelaxOptions options = on(1, 1, Boundary::torus);
    options.iterations = 3;
    options.gaussian = 20;
    options.run_on.backend = GetParam();
    EXPECT_THROW(relax(random_points(500, 1, 1, 1), nullptr, options, stop), Cancelled);
    EXPECT_EQ(stop.rounds, 7u);
}

TEST(Pullers, give_the_same_spots) {
    RelaxOptions options = on(1, 1, Boundary::torus);
    options.gaussian = 4;
    const std::vector<Point> points = random_points(700, 1, 1, 3);
    const GaussianField field = make_gaussian(points.size(), options);
    const std::vector<Spot> start = spots_of(points, field, options, nobody_asks);
    std::vector<std::vector<Spot>> ends;
    for (const cpu::Puller* const puller : cpu::all_pullers())
        ends.push_back(descended(*cpu::make_gaussian_backend(field, start, {}, *puller), 4));
    for (const std::vector<Spot>& end : ends) EXPECT_TRUE(end == ends.front());
}

// The mean power at frequencies below 0.3 sqrt(N), in double.
double low_power(const std::vector<Point>& points, double width) {
    const auto count = static_cast<double>(points.size());
    const int most = static_cast<int>(0.3 * std::sqrt(count) * std::max(width, 1 / width)) + 1;
    double sum = 0;
    int frequencies = 0;
    for (int kx = 0; kx <= most; ++kx)
        for (int ky = -most; ky <= most; ++ky) {
            const double squared = kx * kx / width + ky * ky * width;
            if (squared == 0 || squared >= 0.09 * count) continue;
            std::complex<double> wave = 0;
            for (const Point& point : points)
                wave +=
                    std::polar(1.0, -2 * std::numbers::pi * (kx * point.x / width + ky * point.y));
            sum += std::norm(wave) / count;
            ++frequencies;
        }
    return sum / frequencies;
}

Relaxed evened(std::uint64_t count, const RelaxOptions& options, std::uint64_t seed) {
    Request request;
    request.mode = Mode::stratified;
    request.domain = options.domain;
    request.count = count;
    request.seed = seed;
    return relax(sample(request).points, nullptr, options);
}

TEST(LowFrequencies, have_no_power_on_a_torus_and_points_keep_a_distance) {
    for (const double width : {1.0, 2.5}) {
        RelaxOptions options = on(width, 1, Boundary::torus);
        options.iterations = 30;
        const Relaxed relaxed = evened(1000, options, 3);
        EXPECT_GT(low_power(relaxed.points, width), 1e-4) << width;
        options.gaussian = 150;
        const Relaxed smooth = evened(1000, options, 3);
        EXPECT_LT(low_power(smooth.points, width), 1e-8) << width;
        EXPECT_GT(judge::relative_distance(options.domain, smooth.points), 0.82) << width;
    }
}

TEST(LowFrequencies, are_not_bought_with_the_distance_that_was_asked_for) {
    RelaxOptions options = on(1, 1, Boundary::torus);
    options.iterations = 30;
    options.gaussian = 150;
    options.gaussian_distance = 0;
    const double without =
        judge::relative_distance(options.domain, evened(1000, options, 3).points);
    options.gaussian_distance = 0.95;
    EXPECT_GT(judge::relative_distance(options.domain, evened(1000, options, 3).points),
              without + 0.05);
}

// The rms error of integrals of Gaussians over a unit box, as the points estimate them; relative.
double error_of_integrals(const std::vector<Point>& points) {
    constexpr double kWidth = 0.1;
    const auto exact = [&](double c) {
        return kWidth * std::sqrt(std::numbers::pi / 2) *
               (std::erf((1 - c) / (kWidth * std::numbers::sqrt2)) +
                std::erf(c / (kWidth * std::numbers::sqrt2)));
    };
    double squares = 0;
    const std::vector<Point> centres = random_points(40, 1, 1, 5);
    for (const Point& centre : centres) {
        double sum = 0;
        for (const Point& point : points)
            sum += std::exp(-(std::pow(point.x - centre.x, 2) + std::pow(point.y - centre.y, 2)) /
                            (2 * kWidth * kWidth));
        squares += std::pow(
            sum / static_cast<double>(points.size()) / (exact(centre.x) * exact(centre.y)) - 1, 2);
    }
    return std::sqrt(squares / static_cast<double>(centres.size()));
}

TEST(Integrals, over_a_box_are_several_times_as_exact_as_with_relaxed_points) {
    RelaxOptions options = on(1, 1, Boundary::box);
    options.iterations = 30;
    options.measure = true;
    const double relaxed = error_of_integrals(evened(1024, options, 1).points);
    options.gaussian = 150;
    const Relaxed smooth = evened(1024, options, 1);
    EXPECT_LT(error_of_integrals(smooth.points), std::min(relaxed / 3, 1e-3)) << relaxed;
    EXPECT_EQ(smooth.evenness->after, smooth.evenness->after_voronoi);
    EXPECT_GT(judge::relative_distance(options.domain, smooth.points), 0.8);
}

// The forces of the edges in whole numbers against the same in double.
TEST(Edges, attract_as_an_even_domain_does) {
    RelaxOptions options = on(2, 1, Boundary::box);
    options.gaussian = 1;
    const GaussianField field = make_gaussian(200, options);
    const double unit = 1 << field.domain.bits;
    const double width = field.domain.width / unit, height = field.domain.height / unit;
    const auto axis = [](double at, double side) {
        return std::exp(-at * at / 2) - std::exp(-(side - at) * (side - at) / 2);
    };
    const auto across = [](double at, double side) {
        return std::sqrt(std::numbers::pi / 2) *
               (std::erf((side - at) / std::numbers::sqrt2) + std::erf(at / std::numbers::sqrt2));
    };
    for (const double x : {0.0, 0.3, 2.0, 10.0, 19.9})
        for (const double y : {0.1, 1.7, 5.0, 9.5}) {
            const Spot spot{static_cast<std::uint32_t>(x * unit),
                            static_cast<std::uint32_t>(y * unit)};
            const Force force = force_of_edges(field, spot);
            const double of_force = std::ldexp(1.0, GAUSSIAN_WEIGHT_BITS) * unit;
            EXPECT_NEAR(static_cast<double>(force.x) / of_force, axis(x, width) * across(y, height),
                        2e-6);
            EXPECT_NEAR(static_cast<double>(force.y) / of_force, axis(y, height) * across(x, width),
                        2e-6);
        }
}

// Pinned, because the tables come from floats: another machine must not have others.
TEST(Tables, are_the_same_on_every_machine) {
    RelaxOptions options;
    options.gaussian = 1;
    const GaussianField field = make_gaussian(4096, options);
    const auto sum_of = [](const std::vector<std::int32_t>& table) {
        std::uint64_t sum = 0;
        for (const std::int32_t value : table)
            sum = sum * 6364136223846793005u + static_cast<std::uint32_t>(value);
        return sum;
    };
    EXPECT_EQ(sum_of(field.weights), 2415359237319726896u);
    EXPECT_EQ(sum_of(field.edge_pulls), 3484801692287463851u);
    EXPECT_EQ(sum_of(field.edge_areas), 6604758160153381933u);
    for (std::size_t i = 0; i < GAUSSIAN_ENTRIES; i += 97) {
        const double squared = static_cast<double>(i) / GAUSSIAN_ENTRIES_A_UNIT;
        const double push =
            squared < 0.81 ? std::min(8.0, 0.5 * (0.9 / std::sqrt(squared) - 1)) : 0;
        EXPECT_NEAR(field.weights[i], std::ldexp(std::exp(-squared / 2) + push, 24), 0.51) << i;
    }
}

TEST(Gaussian, IsRefusedForACrowdOfPoints) {
    RelaxOptions options;
    options.iterations = 0;
    options.gaussian = 1;
    std::vector<Point> crowd = random_points(20000, 1, 1, 1);
    for (std::size_t i = 0; i < 1100; ++i) crowd[i] = {0.255, 0.505};
    const std::string crowded = refusal_of([&] { relax(crowd, nullptr, options); });
    EXPECT_TRUE(crowded.starts_with("points (0.255, 0.505): over 1024 points lie in two by two"))
        << crowded;
    const std::string large =
        "gaussian 1: is for at most 2^28 points, 2^18 mean spacings along a side";
    EXPECT_EQ(refusal_of([&] { make_gaussian((1U << 28) + 1, options); }), large);
    EXPECT_EQ(refusal_of([&] { make_gaussian(1U << 28, options); }), "accepted");
    options.domain.width = 1000;
    EXPECT_EQ(refusal_of([&] { make_gaussian(69'000'000, options); }), large);
    EXPECT_EQ(refusal_of([&] { make_gaussian(68'000'000, options); }), "accepted");
}

}  // namespace
}  // namespace lacuna::relaxing::tests
