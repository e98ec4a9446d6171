// Makes work without an observer stop for Ctrl-C.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <system_error>

namespace lacuna::python {

namespace nb = nanobind;

// Throws Unavailable if the system refuses the thread.
template <typename Work>
auto on_a_thread(Work work) {
    try {
        return std::async(std::launch::async, work);
    } catch (const std::system_error& error) {
        throw Unavailable("the system makes no further thread (" + error.code().message() +
                          "): allow more of them or more memory (ulimit -u, ulimit -v)");
    }
}

// Calls work(stop) on a new thread and waits for it with the GIL released. Meanwhile it runs
// Python's signal handlers. When one of them raises an exception, `stop` becomes true and the work
// should throw Cancelled. The exception is thrown after the work has ended.
template <typename Work>
auto in_background(Work work) {
    constexpr std::chrono::milliseconds kInterval{20};
    std::atomic<bool> stop = false;
    std::optional<nb::python_error> raised;
    const nb::gil_scoped_release no_gil;
    auto result = on_a_thread([&] { return work(stop); });
    while (!stop && result.wait_for(kInterval) != std::future_status::ready) {
        const nb::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() == 0) continue;
        raised.emplace();
        stop = true;
    }
    result.wait();
    if (raised) throw nb::python_error(std::move(*raised));
    return result.get();
}

}  // namespace lacuna::python
