// Given several seeds, the sets equal the sets of each seed alone, in order, however they are made.
#include <lacuna/many.h>

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <sys/resource.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace many_test {

using namespace lacuna;
using Seeds = std::vector<std::uint64_t>;

Request request_of(double radius, std::uint32_t threads = 0) {
    Request request;
    request.radius = radius;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = "cpu";
    request.run_on.threads = threads;
    return request;
}

// Compares all sets with sample()'s, and counts them.
std::size_t expect_same_as_alone(const Request& request, const Seeds& seeds) {
    std::size_t at = 0;
    sample_many(request, seeds, [&](std::uint64_t seed, Result set) {
        ASSERT_LT(at, seeds.size());
        EXPECT_EQ(seed, seeds[at++]);
        Request alone = request;
        alone.seed = seed;
        const Result expected = sample(alone);
        EXPECT_EQ(set.points, expected.points) << "seed " << seed;
        EXPECT_EQ(set.maximal, expected.maximal);
        EXPECT_EQ(set.rounds, expected.rounds);
    });
    return at;
}

TEST(SampleMany, GivesTheSetOfEachSeedInOrderOnAnyNumberOfThreads) {
    Seeds seeds{7, 3, 3, std::numeric_limits<std::uint64_t>::max()};
    for (std::uint64_t seed = 0; seed < 300; ++seed) seeds.push_back(seed);  // several batches
    for (const std::uint32_t threads : {0U, 1U, 2U})
        EXPECT_EQ(expect_same_as_alone(request_of(0.1, threads), seeds), seeds.size());
}

// Sets of all other modes and kinds are compared by hostile.
TEST(SampleMany, GivesTheSetOfEachSeedThatIsTooLargeForABatch) {
    EXPECT_EQ(expect_same_as_alone(request_of(0.004), {1, 2, 3}), 3U);
}

TEST(SampleMany, OfNoSeedsMakesNothing) {
    EXPECT_EQ(expect_same_as_alone(request_of(0.1), {}), 0U);
}

// The peak of this process's memory in bytes.
std::size_t peak() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

TEST(SampleMany, NeedsNoMoreMemoryForMoreSeeds) {
    const auto make = [](double radius, std::uint64_t first, std::uint64_t count) {
        Seeds seeds(count);
        std::iota(seeds.begin(), seeds.end(), first);
        std::size_t points = 0;
        sample_many(request_of(radius), seeds,
                    [&](std::uint64_t, const Result& set) { points += set.points.size(); });
        return points * sizeof(Point);
    };
    for (const auto& [radius, sets] : {std::pair{0.004, 20U}, std::pair{0.02, 500U}}) {
        make(radius, 0, sets);
        const std::size_t before = peak();
        const std::size_t made = make(radius, sets, 3 * sets);
        EXPECT_GT(made, std::size_t{39} << 20);
        EXPECT_LT(peak() - before, made / 8);
    }
}

TEST(SampleMany, RefusesWhatSampleRefuses) {
    const auto take = [](std::uint64_t, const Result&) { FAIL() << "a set was made"; };
    const Seeds seeds{1, 2, 3};
    EXPECT_THROW(sample_many(request_of(-1), seeds, take), BadRequest);
    EXPECT_THROW(sample_many(request_of(0.1, 1025), seeds, take), BadRequest);
    Request elsewhere = request_of(0.1);
    elsewhere.run_on.backend = "abacus";
    EXPECT_THROW(sample_many(elsewhere, seeds, take), BadRequest);
    Request snapped = request_of(0.1);
    snapped.paper2011.snap = true;
    EXPECT_THROW(sample_many(snapped, seeds, take), BadRequest);
    EXPECT_THROW(sample_many(snapped, {}, take), BadRequest);
}

TEST(SampleMany, PassesOnWhatTakingASetThrows) {
    int taken = 0;
    EXPECT_THROW(sample_many(request_of(0.1), Seeds{1, 2, 3, 4},
                             [&](std::uint64_t, const Result&) {
                                 if (++taken == 2) throw std::runtime_error("disk");
                             }),
                 std::runtime_error);
    EXPECT_EQ(taken, 2);
}

class Counting : public Observer {
public:
    explicit Counting(std::uint64_t last) : last_(last) {}
    bool keep_going(const Progress& progress) override {
        EXPECT_EQ(std::this_thread::get_id(), caller_);
        EXPECT_GE(progress.points, done_);
        EXPECT_EQ(progress.expected_points, 400U);
        done_ = progress.points;
        return done_ < last_;
    }
    std::uint64_t done() const { return done_; }

private:
    std::uint64_t last_;
    std::uint64_t done_ = 0;
    std::thread::id caller_ = std::this_thread::get_id();
};

TEST(SampleMany, TellsTheCallingThreadHowManySetsAreDoneAndEndsWhenTold) {
    Seeds seeds(400);
    for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i] = i;
    for (const std::uint32_t threads : {1U, 2U}) {
        Counting counting(5);
        std::uint64_t taken = 0;
        EXPECT_THROW(sample_many(
                         request_of(0.1, threads), seeds,
                         [&](std::uint64_t, const Result&) { ++taken; }, counting),
                     Cancelled);
        EXPECT_EQ(taken, 5U);
        EXPECT_EQ(counting.done(), 5U);
    }
}

}  // namespace many_test
