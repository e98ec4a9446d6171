// Watches a run for Python: handles signals, calls the user's progress, and measures seconds by
// verb.
#pragma once

#include <lacuna/cancel.h>
#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace lacuna::python {

namespace nb = nanobind;

// The library calls this observer on the thread that called the run. The GIL is not held then.
class Watch : public Observer {
public:
    // `progress` is called with the numbers of points done and expected, unless it is None.
    explicit Watch(nb::object progress) : progress_(std::move(progress)) {}

    bool keep_going(const Progress& progress) override {
        look(progress.points, progress.expected_points);
        return true;
    }

    // At first and then once in kInterval, runs Python's signal handlers and, once it is known what
    // is expected, calls progress; throws what they raise.
    void look(std::uint64_t done, std::uint64_t expected) {
        const Clock::time_point now = Clock::now();
        if (now < next_) return;
        next_ = now + kInterval;
        const nb::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) throw nb::python_error();
        if (!progress_.is_none() && expected != 0) progress_(done, std::max(done, expected));
    }

    void begin(Verb verb) override { begun_[index_of(verb)] = Clock::now(); }
    void end(Verb verb) override {
        spent_[index_of(verb)] += Clock::now() - begun_[index_of(verb)];
    }

    // Needs the GIL.
    nb::dict seconds() const {
        nb::dict all;
        for (std::size_t i = 0; i < kVerbs; ++i) {
            const std::string_view name = name_of(static_cast<Verb>(i));
            if (spent_[i].count() > 0) all[nb::str(name.data(), name.size())] = spent_[i].count();
        }
        all["total"] = Seconds(Clock::now() - start_).count();
        return all;
    }

private:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    // Least time between two looks: a small part of the 0.2 s within which Ctrl-C must be answered.
    static constexpr std::chrono::milliseconds kInterval{20};
    static constexpr std::size_t kVerbs = 1 + static_cast<std::size_t>(Verb::pen_path);
    static std::size_t index_of(Verb verb) { return static_cast<std::size_t>(verb); }

    nb::object progress_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_;
    std::array<Clock::time_point, kVerbs> begun_{};
    std::array<Seconds, kVerbs> spent_{};
};

// Releases the GIL. Meanwhile work of the library that has no observer answers Ctrl-C.
class Unlocked {
public:
    Unlocked() : scope_([this] { return watch_.keep_going({}); }) {}

private:
    Watch watch_{nb::none()};
    CancelScope scope_;
    nb::gil_scoped_release no_gil_;
};

}  // namespace lacuna::python
