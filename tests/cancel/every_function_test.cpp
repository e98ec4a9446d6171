// Given any public function that may take long, when it is cancelled at any of the moments at which
// it asks, then it asks no more and ends; and the more there is to do, the more often it asks.
//
// With LACUNA_GAPS=N in the environment the test AsksOften only prints, for N times the work, how
// long each call takes and how long the longest time is in which it does not ask.
#include <gtest/gtest.h>
#include <lacuna/cancel.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <regex>
#include <set>
#include <string>

#include "cancel/calls.h"

namespace lacuna {
namespace {

using tests::Call;

// These take no time that grows with what they are given, or are short for all that they take.
const std::set<std::string> kShort{"devices",        "distances_by_sum", "distances_by_union",
                                   "expected_count", "inks_of",          "name_of",
                                   "paper_of",       "ask_older",        "domain_around",
                                   "domain_like",    "read_picture",     "check",
                                   "claim_of",       "role_called",      "has_distance"};

double seconds_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Says no to one of the questions, counted from 1, or to none.
class Answers {
public:
    explicit Answers(std::uint64_t no = 0) : no_(no) {}

    void run(const Call& call) {
        last_ = seconds_now();
        const double begun = last_;
        {
            const CancelScope scope([this] { return answer(); });
            call.run();
        }
        note_gap();
        taken = last_ - begun;
    }

    std::uint64_t questions = 0;
    std::uint64_t questions_after_no = 0;
    double longest_gap = 0;  // in seconds of the processor
    double taken = 0;

private:
    bool answer() {
        note_gap();
        ++questions;
        if (no_ != 0 && questions > no_) ++questions_after_no;
        return questions != no_;
    }
    void note_gap() {
        const double now = seconds_now();
        longest_gap = std::max(longest_gap, now - last_);
        last_ = now;
    }

    std::uint64_t no_;
    double last_ = 0;
};

// How often the call asks; nothing if its backend is missing here.
std::optional<std::uint64_t> questions_of(const Call& call) {
    Answers answers;
    try {
        answers.run(call);
    } catch (const Unavailable&) {
        return std::nullopt;
    }
    return answers.questions;
}

TEST(EveryFunction, IsAmongTheCallsOrShort) {
    std::set<std::string> called;
    for (const Call& call : tests::calls(1)) called.insert(call.function());
    const std::regex function(
        R"(^(?=[A-Za-z])(?:(?:[\w:<>, ]+[ >])(\w+)\([^;{]*$|(?:[\w:<>, ]+[ >])(\w+)\(.*\);))");
    std::size_t found = 0;
    for (const auto& header : std::filesystem::directory_iterator(LACUNA_HEADERS)) {
        std::ifstream file(header.path());
        for (std::string line; std::getline(file, line);) {
            std::smatch parts;
            if (!std::regex_search(line, parts, function) || line.starts_with("using")) continue;
            const std::string name = parts[1].matched ? parts[1] : parts[2];
            ++found;
            EXPECT_TRUE(called.contains(name) || kShort.contains(name))
                << name << " of " << header.path();
        }
    }
    EXPECT_GE(found, 35u);
}

TEST(EveryFunction, AsksTheMoreOftenTheMoreThereIsToDo) {
    const char* const by_hand = std::getenv("LACUNA_GAPS");
    if (by_hand != nullptr) {
        for (const Call& call : tests::calls(std::stoul(by_hand))) {
            Answers answers;
            try {
                answers.run(call);
            } catch (const Unavailable&) {
                continue;
            }
            std::printf("%-40s %8.3f s, asks %7llu times, longest gap %.4f s\n", call.name.c_str(),
                        answers.taken, static_cast<unsigned long long>(answers.questions),
                        answers.longest_gap);
        }
        return;
    }
    constexpr std::size_t kTimes = 4;
    const std::vector<Call> few = tests::calls(1), many = tests::calls(kTimes);
    for (std::size_t i = 0; i < few.size(); ++i) {
        const auto seldom = questions_of(few[i]), often = questions_of(many[i]);
        if (!seldom || !often) continue;
        EXPECT_GE(*often, 2u) << few[i].name;
        // Not four times as often: some ask once for each region, of which there are about 96. Who
        // waits for threads asks the more often the longer they take, on a busy machine often.
        constexpr std::uint64_t kOften = 200;
        EXPECT_TRUE(*often > *seldom || *often >= kOften) << few[i].name << ' ' << *often;
    }
}

TEST(EveryFunction, ThatIsCancelledAtAnyMomentAsksNoMoreAndEnds) {
    std::mt19937_64 chance(18);
    for (const Call& call : tests::calls(2)) {
        const auto questions = questions_of(call);
        if (!questions) continue;
        for (int time = 0; time < 2; ++time) {
            const std::uint64_t no = 1 + chance() % *questions;
            Answers answers(no);
            try {
                answers.run(call);
                EXPECT_LT(answers.questions, no)
                    << call.name << " went on";  // was faster this time
            } catch (const Cancelled&) {
                EXPECT_EQ(answers.questions, no) << call.name;
            }
            EXPECT_EQ(answers.questions_after_no, 0u) << call.name;
        }
    }
}

TEST(ACancelScope, EndsAFunctionWithWhatItThrows) {
    const Call call = tests::calls(1).front();
    const CancelScope scope([]() -> bool { throw std::domain_error("enough"); });
    EXPECT_THROW(call.run(), std::domain_error);
}

TEST(ACancelScope, MayCallFunctionsThatAsk) {
    int questions = 0;
    const CancelScope scope([&] {
        ++questions;
        return sample({.radius = 0.05}).maximal;
    });
    sample({.radius = 0.01});
    EXPECT_GT(questions, 0);
    class Sampling : public Observer {
    public:
        bool keep_going(const Progress&) override {
            ++questions;
            return sample({.radius = 0.05}).maximal;
        }
        int questions = 0;
    };
    Sampling sampling;
    sample({.radius = 0.01}, sampling);
    EXPECT_GT(sampling.questions, 0);
}

TEST(ACancelScope, IsAskedBesideAnObserverAndOlderScopes) {
    class Counting : public Observer {
    public:
        bool keep_going(const Progress&) override { return ++questions > 0; }
        int questions = 0;
    };
    Counting observer;
    int older = 0, younger = 0;
    const CancelScope first([&] { return ++older > 0; });
    {
        const CancelScope second([&] { return ++younger > 0; });
        sample({.radius = 0.01}, observer);
    }
    EXPECT_GT(observer.questions, 0);
    EXPECT_EQ(older, younger);
    EXPECT_GE(younger, observer.questions);
    sample({.radius = 0.01});
    EXPECT_GT(older, younger);
}

}  // namespace
}  // namespace lacuna
