// Observers of a run: several that are called one after another, and a stopwatch.
#pragma once

#include <lacuna/lacuna.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace lacuna::cli {

class Observers : public Observer {
public:
    explicit Observers(std::vector<std::reference_wrapper<Observer>> all) : all_(std::move(all)) {}

    bool keep_going(const Progress& progress) override {
        bool all_agree = true;
        for (Observer& observer : all_) all_agree = observer.keep_going(progress) && all_agree;
        return all_agree;
    }
    void begin(Verb verb) override {
        for (Observer& observer : all_) observer.begin(verb);
    }
    void end(Verb verb) override {
        for (Observer& observer : all_) observer.end(verb);
    }
    bool times_verbs() const override {
        return std::any_of(all_.begin(), all_.end(),
                           [](const Observer& observer) { return observer.times_verbs(); });
    }

private:
    std::vector<std::reference_wrapper<Observer>> all_;
};

inline constexpr std::array kVerbs{Verb::invert, Verb::locate,   Verb::admit,    Verb::subtract,
                                   Verb::refine, Verb::transfer, Verb::first_use};
inline constexpr std::array kRelaxVerbs{Verb::assign, Verb::accumulate, Verb::move, Verb::descend};
inline constexpr std::array kStippleVerbs{Verb::read, Verb::pen_path};

// Measures the seconds of each verb, and the seconds since its construction. Without `times_verbs`
// a device is not slowed down by waits for each verb: most of its time is then that of transfer.
class Stopwatch : public Observer {
public:
    explicit Stopwatch(bool times_verbs = true) : times_verbs_(times_verbs) {}

    void begin(Verb verb) override { begun_[index_of(verb)] = Clock::now(); }
    void end(Verb verb) override {
        spent_[index_of(verb)] += Clock::now() - begun_[index_of(verb)];
    }
    bool times_verbs() const override { return times_verbs_; }

    double seconds(Verb verb) const { return spent_[index_of(verb)].count(); }
    double seconds_so_far() const { return Seconds(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;

    static constexpr std::size_t kCount = 1 + static_cast<std::size_t>(Verb::pen_path);
    static std::size_t index_of(Verb verb) { return static_cast<std::size_t>(verb); }

    bool times_verbs_;
    Clock::time_point start_ = Clock::now();
    std::array<Clock::time_point, kCount> begun_{};
    std::array<Seconds, kCount> spent_{};
};

}  // namespace lacuna::cli
