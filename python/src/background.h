// Makes work without an observer stop for Ctrl-C.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>

namespace lacuna::python {

namespace nb = nanobind;

// Calls work(stop) on a new thread and waits for it with the GIL released. Meanwhile it runs
// Python's signal handlers. When one of them raises an exception, `stop` becomes true and the work
// should throw Cancelled. The exception is thrown after the work has ended.
template <typename Work>
auto in_background(Work work) {
    constexpr std::chrono::milliseconds kInterval{20};
    std::atomic<bool> stop = false;
    std::optional<nb::python_error> raised;
    const nb::gil_scoped_release no_gil;
    auto result = std::async(std::launch::async, [&] { return work(stop); });
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
