// Several threads of a program use the library at once, from the first call: every ctest test is a
// process of its own.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "backends/available.h"

namespace lacuna {
namespace {

bool are_equal(const std::vector<Point>& a, const std::vector<Point>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](Point p, Point q) { return p.x == q.x && p.y == q.y; });
}

Request small_request(const std::string& backend, std::uint64_t seed) {
    Request request;
    request.radius = 0.05;
    request.seed = seed;
    request.run_on.backend = backend;
    return request;
}

constexpr int kThreads = 8;

// Calls work(thread) in several threads at once.
template <typename Work>
void in_threads(Work work) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) threads.emplace_back([&work, i] { work(i); });
}

// The number of calls of each thread; LACUNA_THREAD_CALLS sets more.
int calls_of_a_thread() {
    const char* const given = std::getenv("LACUNA_THREAD_CALLS");
    return given == nullptr ? 5 : std::stoi(given);
}

// Each thread goes from one backend to the next, so that all are used at once, from the first call.
// Backends without a device, or that this build lacks, are left out.
class Threads : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Backend, Threads, testing::Values("cpu", "opencl", "vulkan", "all"),
                         tests::name_of_parameter);

TEST_P(Threads, ThatSampleAtOnceAllGetTheirSets) {
    std::vector<std::string> backends{GetParam()};
    if (GetParam() == "all") backends = {"cpu", "opencl", "vulkan", "reference"};
    constexpr std::uint64_t kSeeds = 4;
    std::vector<std::vector<Point>> expected;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
        expected.push_back(sample(small_request("reference", seed)).points);
    const int calls = calls_of_a_thread();
    std::atomic<int> made = 0;
    std::vector<std::string> errors(kThreads);
    in_threads([&](int thread) {
        for (int call = 0; call < calls; ++call) {
            const auto turn = static_cast<std::size_t>(thread + call);
            const std::uint64_t seed = turn / backends.size() % kSeeds;
            Request request = small_request(backends[turn % backends.size()], seed);
            request.run_on.threads = static_cast<std::uint32_t>(turn % 5);
            try {
                if (!are_equal(sample(request).points, expected[seed]))
                    errors[static_cast<std::size_t>(thread)] =
                        "other points: " + request.run_on.backend;
                ++made;
            } catch (const Unavailable&) {
            } catch (const std::exception& error) {
                errors[static_cast<std::size_t>(thread)] = error.what();
            }
        }
    });
    for (const std::string& error : errors) EXPECT_EQ(error, "");
    // Looks for the backend only now, so that no thread finds it already initialised.
    if (GetParam() != "all") tests::skip_or_fail_without(GetParam());
    if (testing::Test::IsSkipped() || testing::Test::HasFailure()) return;
    EXPECT_GE(made, kThreads * calls / 2) << "cpu and reference, at least";
}

TEST(ThreadsOfAProgram, ThatListDevicesFirstAllSeeTheSame) {
    std::vector<std::size_t> counts(kThreads);
    in_threads([&](int thread) { counts[static_cast<std::size_t>(thread)] = devices().size(); });
    for (const std::size_t count : counts) EXPECT_EQ(count, devices().size());
}

TEST(ThreadsOfAProgram, OfOtherNumbersAreNoWordOnStandardError) {
    testing::internal::CaptureStderr();
    in_threads([](int thread) {
        for (int call = 0; call < 20; ++call) {
            Request request = small_request("cpu", 1);
            request.radius = 0.01;
            request.run_on.threads = static_cast<std::uint32_t>(2 + 2 * thread);
            sample(request);
        }
    });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

struct Thrown : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ThrowsAtTheEnd : Observer {
    void end(Verb verb) override {
        if (verb == Verb::admit) throw Thrown("the observer's own");
    }
};

TEST(AnObserver, ThatThrowsAtAVerbsEndEndsTheCallWithItsException) {
    ThrowsAtTheEnd observer;
    EXPECT_THROW(sample(small_request("cpu", 1), observer), Thrown);
}

// A forked process does not have the driver's threads.
class Forks : public tests::OnBackend {};
INSTANTIATE_TEST_SUITE_P(Backend, Forks, tests::kDeviceBackends, tests::name_of_parameter);

TEST_P(Forks, OfAProgramThatUsedADeviceAreToldThatTheyCannot) {
    sample(small_request(GetParam(), 1));
    const pid_t child = fork();
    if (child == 0) {
        alarm(20);
        try {
            sample(small_request(GetParam(), 1));
        } catch (const Unavailable& error) {
            _exit(std::string(error.what()).find("forked") != std::string::npos ? 17 : 2);
        }
        _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 17);
}

}  // namespace
}  // namespace lacuna
