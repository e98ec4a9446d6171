// Seconds by verb, and in all since it was made.
#pragma once

#include <lacuna/lacuna.h>
#include <array>
#include <chrono>
#include <cstddef>

namespace lacuna::cli {

inline constexpr std::array kVerbs{Verb::invert, Verb::locate,   Verb::admit,    Verb::subtract,
                                   Verb::refine, Verb::transfer, Verb::first_use};

class Stopwatch : public Observer {
public:
    void begin(Verb verb) override { begun_[index_of(verb)] = Clock::now(); }
    void end(Verb verb) override {
        spent_[index_of(verb)] += Clock::now() - begun_[index_of(verb)];
    }

    double seconds(Verb verb) const { return spent_[index_of(verb)].count(); }
    double seconds_so_far() const { return Seconds(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;

    static std::size_t index_of(Verb verb) { return static_cast<std::size_t>(verb); }

    Clock::time_point start_ = Clock::now();
    std::array<Clock::time_point, kVerbs.size()> begun_{};
    std::array<Seconds, kVerbs.size()> spent_{};
};

}  // namespace lacuna::cli
