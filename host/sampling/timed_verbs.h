// Decorators of the backend and of the marginal that report the verbs of the loop to the observer.
#pragma once

#include <lacuna/lacuna.h>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "backends/backend.h"
#include "plan/plan.h"
#include "rounds/marginal.h"

namespace lacuna {

// Calls the observer when a verb begins, and when it ends or throws. An exception of the observer
// ends the run, unless another exception is ending it already.
class Timed {
public:
    Timed(Observer& observer, Verb verb)
        : observer_(observer), verb_(verb), exceptions_(std::uncaught_exceptions()) {
        observer_.begin(verb_);
    }
    ~Timed() noexcept(false) {
        try {
            observer_.end(verb_);
        } catch (...) {
            if (std::uncaught_exceptions() == exceptions_) throw;
        }
    }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

private:
    Observer& observer_;
    Verb verb_;
    int exceptions_;  // uncaught when the verb began
};

template <typename AnyBackend>
class TimedBackend {
public:
    TimedBackend(AnyBackend& backend, Observer& observer) : backend_(backend), observer_(observer) {
        if (observer_.times_verbs()) backend_.time_verbs();
    }

    void locate(std::span<const Draw> draws) {
        const Timed timed(observer_, Verb::locate);
        backend_.locate(draws);
    }
    void admit() {
        const Timed timed(observer_, Verb::admit);
        backend_.admit();
    }
    void subtract() {
        const Timed timed(observer_, Verb::subtract);
        backend_.subtract();
    }
    void refine(bool halve) {
        const Timed timed(observer_, Verb::refine);
        backend_.refine(halve);
    }
    auto finish_round() {
        const Timed timed(observer_, Verb::transfer);
        return backend_.finish_round();
    }
    auto located() {
        const Timed timed(observer_, Verb::transfer);
        return backend_.located();
    }
    auto snapshot() { return backend_.snapshot(); }

private:
    AnyBackend& backend_;
    Observer& observer_;
};

class TimedMarginal {
public:
    template <typename AnyBackend>
    TimedMarginal(const Plan& plan, AnyBackend& backend, std::function<void()> poll,
                  Observer& observer)
        : marginal_(plan, backend.workers(), std::move(poll),
                    [&](std::size_t count) { return backend.room_for_draws(count); }),
          observer_(observer) {}

    void rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t bin_width,
                 std::span<const std::uint32_t> bin_widths = {},
                 std::span<const std::uint32_t> copy_ends = {}) {
        const Timed timed(observer_, Verb::invert);
        marginal_.rebuild(free_lengths, bin_width, bin_widths, copy_ends);
    }
    std::span<const Draw> invert(std::uint64_t first_number, std::uint64_t count) {
        const Timed timed(observer_, Verb::invert);
        return marginal_.invert(first_number, static_cast<std::uint32_t>(count));
    }
    std::uint64_t total() const { return marginal_.total(); }

private:
    Marginal marginal_;
    Observer& observer_;
};

}  // namespace lacuna
