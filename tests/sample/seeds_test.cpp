// Sets of different seeds are independent: a mean over seeds is as exact as their spread says.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "fields.h"

namespace lacuna::tests {
namespace {

// A way to make a set of kCount points in a unit square.
constexpr std::uint64_t kCount = 400;
struct Recipe {
    std::string name;
    Mode mode;
    Boundary boundary;
    bool has_picture;
    std::uint32_t iterations;
};
void PrintTo(const Recipe& recipe, std::ostream* out) {
    *out << recipe.name;
}

double darkness(double x, double y) {
    return 1.1 + std::sin(2 * std::numbers::pi * x) * std::cos(2 * std::numbers::pi * y);
}

std::vector<Point> set_of(const Recipe& recipe, std::uint64_t seed) {
    Request request;
    request.domain.boundary = recipe.boundary;
    request.mode = recipe.mode;
    request.count = kCount;
    request.seed = seed;
    if (recipe.mode == Mode::pixels) request.on_pixels = Raster{60, 60};
    static const Field field = made_field(40, 40, darkness);
    if (recipe.has_picture) request.field = &field;
    const std::vector<Point> points = sample(request).points;
    if (recipe.iterations == 0) return points;
    RelaxOptions options;
    options.domain = request.domain;
    options.iterations = recipe.iterations;
    return relax(points, request.field, options).points;
}

// Discs that keep away from the edges of a box, along which relaxed points lie in rows.
struct Disc {
    Point centre;
    double radius;

    explicit Disc(std::mt19937& random) {
        const auto between = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random()) * 0x1p-32;
        };
        radius = between(0.05, 0.25);
        const double margin = radius + 0.15;
        centre = {between(margin, 1 - margin), between(margin, 1 - margin)};
    }
    bool contains(Point at) const { return std::hypot(at.x - centre.x, at.y - centre.y) < radius; }
    // The share of the mass of `importance` on a fine lattice.
    template <typename Importance>
    double share(std::size_t side, const Importance& importance) const {
        double all = 0, inside = 0;
        for (std::size_t i = 0; i < side * side; ++i) {
            const Point at{(static_cast<double>(i % side) + 0.5) / static_cast<double>(side),
                           (static_cast<double>(i / side) + 0.5) / static_cast<double>(side)};
            const double one = importance(at.x, at.y);
            all += one;
            if (contains(at)) inside += one;
        }
        return inside / all;
    }
};

class Seeds : public testing::TestWithParam<Recipe> {};

TEST_P(Seeds, ErrOfAMeanAsTheirSpreadSays) {
    constexpr std::size_t kSeeds = 60, kDiscs = 150;
    const Recipe& recipe = GetParam();
    std::vector<std::vector<Point>> sets;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) sets.push_back(set_of(recipe, seed));
    std::mt19937 random(1);
    double squared_error = 0, said = 0;
    for (std::size_t k = 0; k < kDiscs; ++k) {
        const Disc disc(random);
        const double share =
            disc.share(recipe.mode == Mode::pixels ? 60 : 200,
                       [&](double x, double y) { return recipe.has_picture ? darkness(x, y) : 1; });
        double sum = 0, squares = 0;
        for (const std::vector<Point>& points : sets) {
            double inside = 0;
            for (const Point& point : points) inside += disc.contains(point) ? 1 : 0;
            const double error = inside - share * static_cast<double>(points.size());
            sum += error;
            squares += error * error;
        }
        const double mean = sum / kSeeds;
        squared_error += mean * mean;
        said += (squares / kSeeds - mean * mean) / (kSeeds - 1);
    }
    EXPECT_LT(std::sqrt(squared_error / said), 1.15);
}

INSTANTIATE_TEST_SUITE_P(
    Of, Seeds,
    testing::Values(
        Recipe{"starts on a torus", Mode::stratified, Boundary::torus, false, 0},
        Recipe{"starts in a box", Mode::stratified, Boundary::box, false, 0},
        Recipe{"starts on a picture", Mode::stratified, Boundary::box, true, 0},
        Recipe{"sets relaxed 5 times on a torus", Mode::stratified, Boundary::torus, false, 5},
        Recipe{"sets relaxed 30 times in a box", Mode::stratified, Boundary::box, false, 30},
        Recipe{"samples on pixels of a torus", Mode::pixels, Boundary::torus, false, 0}));

}  // namespace
}  // namespace lacuna::tests
