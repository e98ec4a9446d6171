// Given an observer, a run reports its verbs and asks now and then whether to go on, also within a
// verb. After a no it asks no more and ends.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

namespace observer_test {

using namespace lacuna;

constexpr std::size_t kVerbs = 7;

std::size_t index_of(Verb verb) {
    return static_cast<std::size_t>(verb);
}

// Counts the calls; says no to the question of this number within this verb, if there is one.
class Listener : public Observer {
public:
    Listener() = default;
    Listener(Verb verb, std::uint64_t question) : verb_(verb), question_(question) {}

    bool keep_going(const Progress& progress) override {
        EXPECT_GE(progress.expected_points, progress.points);
        EXPECT_GE(progress.points, last_.points);
        EXPECT_GE(progress.rounds, last_.rounds);
        last_ = progress;
        if (has_said_no_) ++questions_after_no;
        if (!now_) {
            ++questions_between;
            return true;
        }
        const std::uint64_t so_far = ++questions_within[index_of(*now_)];
        has_said_no_ = has_said_no_ || (now_ == verb_ && so_far == question_);
        return !has_said_no_;
    }
    void begin(Verb verb) override {
        if (has_said_no_) ++begun_after_no;
        EXPECT_FALSE(now_.has_value()) << "one verb within another";
        now_ = verb;
        ++begun[index_of(verb)];
    }
    void end(Verb verb) override {
        EXPECT_EQ(now_, verb);
        now_.reset();
    }

    bool has_said_no() const { return has_said_no_; }
    bool is_within_a_verb() const { return now_.has_value(); }

    std::array<std::uint64_t, kVerbs> begun{};
    std::array<std::uint64_t, kVerbs> questions_within{};
    std::uint64_t questions_between = 0;
    std::uint64_t questions_after_no = 0;
    std::uint64_t begun_after_no = 0;

private:
    std::optional<Verb> now_;
    std::optional<Verb> verb_;
    std::uint64_t question_ = 0;
    bool has_said_no_ = false;
    Progress last_{};
};

Request request_of(Mode mode, double radius, std::uint32_t threads) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.run_on.threads = threads;
    request.run_on.backend = "cpu";
    return request;
}

TEST(AnObserver, HearsOfRefiningInExactAndNotInLines) {
    Listener in_exact;
    const Result exact = sample(request_of(Mode::exact, 0.01, 1), in_exact);
    EXPECT_GT(in_exact.begun[index_of(Verb::refine)], 0u);
    EXPECT_GT(in_exact.begun[index_of(Verb::subtract)], 0u);
    EXPECT_EQ(in_exact.begun[index_of(Verb::refine)] + in_exact.begun[index_of(Verb::subtract)],
              exact.rounds);
    EXPECT_EQ(in_exact.begun[index_of(Verb::locate)], exact.rounds);
    EXPECT_EQ(in_exact.begun[index_of(Verb::admit)], exact.rounds);
    EXPECT_GE(in_exact.questions_between, exact.rounds);

    Listener in_lines;
    const Result lines = sample(request_of(Mode::lines, 0.01, 1), in_lines);
    EXPECT_EQ(in_lines.begun[index_of(Verb::refine)], 0u);
    EXPECT_EQ(in_lines.begun[index_of(Verb::subtract)], lines.rounds);
}

TEST(AnObserver, OfOneThreadIsAskedTheMoreOftenWithinAVerbTheMoreThereIsToDo) {
    // There are 330 and 660 columns of lines, each as wide as the radius. Admit asks once in a slab
    // of 64 columns, or more often where a slab has many draws.
    for (const double radius : {0.003, 0.0015}) {
        Listener listener;
        const Result result = sample(request_of(Mode::exact, radius, 1), listener);
        for (const Verb verb : {Verb::locate, Verb::admit, Verb::subtract, Verb::refine}) {
            const std::uint64_t times = listener.begun[index_of(verb)];
            const double columns = 1 / radius / (verb == Verb::admit ? 64 : 1);
            EXPECT_GE(static_cast<double>(listener.questions_within[index_of(verb)]),
                      static_cast<double>(times) * columns / 5)
                << name_of(verb) << " of " << result.points.size() << " points, " << times
                << " times";
        }
    }
}

struct When {
    Verb verb;
    std::uint32_t threads;
};

void PrintTo(const When& when, std::ostream* out) {
    *out << name_of(when.verb) << ", " << when.threads << " threads";
}

class ARefusalWithinAVerb : public testing::TestWithParam<When> {};

TEST_P(ARefusalWithinAVerb, IsTheLastQuestionAndTheRunIsCancelled) {
    const auto [verb, threads] = GetParam();
    for (const std::uint64_t question : {1u, 2u, 20u}) {
        Listener listener(verb, question);
        EXPECT_THROW(sample(request_of(Mode::exact, 0.003, threads), listener), Cancelled);
        EXPECT_TRUE(listener.has_said_no());
        EXPECT_EQ(listener.questions_after_no, 0u);
        EXPECT_EQ(listener.begun_after_no, 0u);
        EXPECT_FALSE(listener.is_within_a_verb()) << "its end was not told";
    }
}

INSTANTIATE_TEST_SUITE_P(OfTheCpuBackend, ARefusalWithinAVerb,
                         testing::Values(When{Verb::invert, 1}, When{Verb::locate, 1},
                                         When{Verb::admit, 1}, When{Verb::subtract, 1},
                                         When{Verb::refine, 1}, When{Verb::locate, 2},
                                         When{Verb::admit, 2}, When{Verb::subtract, 2},
                                         When{Verb::refine, 2}),
                         [](const auto& test) {
                             return std::string(name_of(test.param.verb)) + "With" +
                                    std::to_string(test.param.threads) +
                                    (test.param.threads == 1 ? "Thread" : "Threads");
                         });

TEST(ARefusalBetweenRounds, CancelsInEveryMode) {
    class AfterThree : public Observer {
        bool keep_going(const Progress& progress) override {
            rounds = progress.rounds;
            return progress.rounds < 3;
        }

    public:
        std::uint64_t rounds = 0;
    };
    for (const Mode mode : {Mode::exact, Mode::lines}) {
        AfterThree observer;
        EXPECT_THROW(sample(request_of(mode, 0.01, 1), observer), Cancelled);
        EXPECT_EQ(observer.rounds, 3u);
        // Nothing of it is left, and who is asked and agrees changes nothing.
        Listener agrees;
        EXPECT_EQ(sample(request_of(mode, 0.01, 2), agrees).points,
                  sample(request_of(mode, 0.01, 1)).points);
    }
}

TEST(ARefusalBeforeTheFirstRound, CancelsWhileRadiiAreFoundForAField) {
    class Stop : public Observer {
    public:
        explicit Stop(int at) : at_(at) {}
        bool keep_going(const Progress& progress) override {
            EXPECT_GE(progress.expected_points, 1u);
            return ++asked < at_;
        }
        void begin(Verb) override { ++begun; }
        int asked = 0;
        int begun = 0;

    private:
        int at_;
    };
    // Eight classes of radii; for each class all pixels are looked at.
    Field field{1024, 1024, {}};
    for (std::uint32_t i = 0; i < field.columns * field.rows; ++i)
        field.importance.push_back(1.0 / (1u << 2 * (i / 31 % 8)));
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.metric = Metric::mean;
    request.count = 1000;
    for (const int at : {1, 16, 17, 100, 300}) {
        Stop stop(at);
        EXPECT_THROW(sample(request, stop), Cancelled);
        EXPECT_EQ(stop.asked, at);
        EXPECT_EQ(stop.begun, 0) << at;
    }
}

}  // namespace observer_test
