// Given exact sets of every kind, each is proven maximal; with a point removed it is refuted; and
// with a point moved it is refuted exactly when geometry says that the move broke it.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "backends/requests.h"
#include "verify/exact_sets.h"
#include "verify/sets.h"

namespace lacuna::verify {
namespace {

constexpr std::uint64_t kFirstSeed = 20110;
constexpr int kSets = 2000;

// A set, and the proof of the set or of a variant of it.
struct Made {
    explicit Made(std::uint64_t seed)
        : request(small_exact_request(seed)),
          domain(domain_of(request)),
          points(sample(request).points),
          random(~seed) {}

    double radius() const { return *request.radius; }
    double tolerance() const { return domain.longer_side() * 0x1p-28; }
    Proof proof_of(const std::vector<Point>& some) const {
        return check(some, domain.width, domain.height, domain.torus, radius(), tolerance());
    }
    std::size_t any_index() { return random() % points.size(); }

    Request request;
    Domain domain;
    std::vector<Point> points;
    std::mt19937_64 random;
};

// The sets are made once in a process, and ctest runs all tests of small sets in one process.
const std::vector<Made>& small_sets() {
    static const std::vector<Made> sets = [] {
        std::vector<Made> all;
        all.reserve(kSets);
        for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kSets; ++seed)
            all.emplace_back(seed);
        return all;
    }();
    return sets;
}

// Each test gets fresh copies of the sets, with their random numbers as they were made.
template <typename Test>
void for_each_set(Test test) {
    std::printf("seeds %lu to %lu\n", kFirstSeed, kFirstSeed + kSets - 1);
    for (std::size_t i = 0; i < small_sets().size(); ++i) {
        Made set = small_sets()[i];
        SCOPED_TRACE("seed " + std::to_string(kFirstSeed + i) + ": " +
                     tests::describe(set.request));
        test(set);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(ASmallExactSet, IsMaximalWhateverTheRequest) {
    std::size_t points = 0;
    std::size_t with_few = 0;
    for_each_set([&](Made& set) {
        const Proof proof = set.proof_of(set.points);
        EXPECT_FALSE(proof.outside.has_value());
        EXPECT_TRUE(proof.kept) << proof.least_distance;
        EXPECT_TRUE(proof.covered) << proof.largest_gap_distance;
        points += set.points.size();
        with_few += set.points.size() <= 4 ? 1U : 0U;
    });
    std::printf("%d sets, %zu points, %zu sets of at most 4 points\n", kSets, points, with_few);
    EXPECT_GT(with_few, 250U);
}

TEST(ASmallExactSet, LessAnyOfItsPointsIsRefuted) {
    for_each_set([](Made& set) {
        std::vector<Point> others = set.points;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(set.any_index()));
        const Proof proof = set.proof_of(others);
        EXPECT_TRUE(proof.kept);
        EXPECT_FALSE(proof.covered);
    });
}

// A random place of the domain at a distance of r / 50 from the point.
Point moved(Made& set, Point point) {
    for (;;) {
        const double angle = random_in(set.random, 0, 2 * std::numbers::pi);
        Point to{point.x + set.radius() / 50 * std::cos(angle),
                 point.y + set.radius() / 50 * std::sin(angle)};
        if (set.domain.torus) {
            to.x -= std::floor(to.x / set.domain.width) * set.domain.width;
            to.y -= std::floor(to.y / set.domain.height) * set.domain.height;
        }
        if (set.domain.contains(to)) return to;
    }
}

struct Share {
    int refuted = 0;
    int all = 0;

    void add(bool is_refuted) {
        refuted += is_refuted ? 1 : 0;
        ++all;
    }
    void print(const char* of) const {
        std::printf("refuted %s: %d of %d, %.1f %%\n", of, refuted, all, 100.0 * refuted / all);
    }
};

// Not every move breaks a set: if the neighbours leave some room, the moved set is maximal, too.
TEST(ASmallExactSet, WithAPointMovedIsRefutedExactlyWhenTheMoveBrokeIt) {
    Share on_torus, in_box, of_many_on_torus, of_many_in_box;
    int too_close_to_call = 0;
    for_each_set([&](Made& set) {
        constexpr int kMoves = 2;
        for (int i = 0; i < kMoves; ++i) {
            const std::size_t index = set.any_index();
            const Point was = set.points[index];
            std::vector<Point> points = set.points;
            points[index] = moved(set, was);
            const Proof proof = set.proof_of(points);

            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t other = 0; other < points.size(); ++other)
                if (other != index)
                    nearest = std::min(nearest, set.domain.distance(points[index], points[other]));
            EXPECT_EQ(proof.kept, nearest >= set.radius());

            const double limit = set.radius() + set.tolerance();
            const double beyond = Surroundings(set.domain, points, was, limit).gap() - limit;
            const bool is_plain = std::abs(beyond) > 1e-10 * set.domain.longer_side();
            too_close_to_call += is_plain ? 0 : 1;
            if (is_plain) {
                EXPECT_EQ(proof.covered, beyond < 0) << beyond;
            }

            const bool is_refuted = !proof.maximal;
            (set.domain.torus ? on_torus : in_box).add(is_refuted);
            if (points.size() >= 30)
                (set.domain.torus ? of_many_on_torus : of_many_in_box).add(is_refuted);
        }
    });
    on_torus.print("on the torus");
    in_box.print("in the box");
    of_many_on_torus.print("on the torus, in sets of at least 30 points");
    of_many_in_box.print("in the box, in sets of at least 30 points");
    EXPECT_LT(too_close_to_call, kSets / 100);
}

// In all but one of a million sets of 60 points, some two points are nearer than 1.02 r. A set has
// about 0.245 such pairs for each of its points (the pair correlation g is 5.6 at distance r).
TEST(ASmallExactSet, OfAtLeast60PointsIsRefutedWhenOneOfTheClosestMovesTowardsTheOther) {
    int sets = 0;
    for_each_set([&](Made& set) {
        if (set.points.size() < 60) return;
        ++sets;
        const Pair pair = closest_pair(set.domain, set.points);
        const Point to = set.points[pair.second];
        Point& from = set.points[pair.first];
        const auto step = [&](double a, double b, double side) {
            double straight = b - a;
            if (set.domain.torus) straight -= std::round(straight / side) * side;
            const double there = a + set.radius() / 50 * straight / pair.distance;
            return there < 0 ? there + side : there >= side ? there - side : there;
        };
        from = {step(from.x, to.x, set.domain.width), step(from.y, to.y, set.domain.height)};
        const Proof proof = set.proof_of(set.points);
        EXPECT_FALSE(proof.kept);
        EXPECT_EQ(proof.first, pair.first);
        EXPECT_EQ(proof.second, pair.second);
    });
    std::printf("%d sets\n", sets);
    EXPECT_GT(sets, 100);
}

TEST(ALargeExactSet, IsMaximalAndLessOneOfItsPointsIsNot) {
    Request request;
    request.radius = 0.001;
    request.domain.boundary = Boundary::torus;
    request.place.backend = "cpu";
    std::vector<Point> points = sample(request).points;
    std::printf("seed %lu, %zu points\n", request.seed, points.size());
    EXPECT_GT(points.size(), 690'000U);
    EXPECT_TRUE(check(points, 1, 1, true, 0.001).maximal);

    const Point gone = points[314'159];
    points.erase(points.begin() + 314'159);
    const Proof proof = check(points, 1, 1, true, 0.001);
    EXPECT_TRUE(proof.kept);
    EXPECT_FALSE(proof.covered);
    EXPECT_LT(Domain({1, 1, true}).distance(proof.largest_gap, gone), 0.001);
}

}  // namespace
}  // namespace lacuna::verify
