// Where the work is done, and how it is watched.
#pragma once

#include <lacuna/errors.h>
#include <lacuna/export.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

// Where the work is done.
struct RunOn {
    // A Device::backend that devices() lists. "auto" is the backend that the environment variable
    // LACUNA_BACKEND names or, where it is unset or empty, the first in the list.
    std::string backend = "auto";
    std::string device{};       // for backends with devices: a number or part of a name
    std::uint32_t threads = 0;  // at most 1024; 0: one for each core
    // sample() refuses sets that take more memory. 0: than the machine has.
    std::uint64_t memory_limit_bytes = 0;
};

// A device that a backend can run on, or a backend that cannot run: `unusable` then says why.
struct Device {
    std::string backend{};
    std::string name{};  // as the driver gives it
    std::string kind{};  // cpu, gpu or other
    std::uint64_t memory_bytes = 0;
    std::uint64_t largest_buffer_bytes = 0;
    std::string unusable{};  // why it cannot be used; empty when it can
};

// The devices of all backends. Backends come in order of preference, and the devices of each in the
// order of their numbers, which RunOn::device names. A backend that this build lacks, or whose
// driver fails, has one entry that says so.
std::vector<Device> devices();

// The steps of a round, of an iteration of relax and of its descent, for observers that time them.
enum class Verb {
    invert,
    locate,
    admit,
    subtract,
    refine,
    transfer,
    first_use,
    assign,
    accumulate,
    move,
    descend,  // a step of RelaxOptions::gaussian
    read,     // of stipple: decoding the picture
    pen_path  // of stipple: ordering the dots along a path
};
std::string_view name_of(Verb verb);

// What a run is doing: admitting points, moving them, or ordering them along a path.
enum class Stage { sampling, relaxing, pen_path };

struct Progress {
    // The points that were admitted. While relaxing: their number times the finished rounds.
    std::uint64_t points = 0;
    std::uint64_t expected_points = 0;  // an estimate, at least `points`
    std::uint64_t rounds = 0;           // finished ones. While relaxing: iterations and steps
    Stage stage = Stage::sampling;
    std::uint64_t all_rounds = 0;  // while relaxing: the number of iterations and steps in all
};

// Watches a run from the calling thread. The library has no clock: an observer that measures times
// reads its own in begin and end.
class Observer {
public:
    virtual ~Observer() = default;
    // Called after each round, and now and then within long ones and before the first. Return false
    // to cancel: sample() then throws Cancelled and does not call again.
    virtual bool keep_going(const Progress&) { return true; }
    virtual void begin(Verb) {}
    virtual void end(Verb) {}
    // Whether end() is to be called only when a device has done the verb. Waiting for each verb
    // slows devices down. Otherwise the time of a round shows in Verb::transfer. Devices then also
    // measure their kernels, for KernelWork::seconds.
    virtual bool times_verbs() const { return false; }
    // The first three functions may throw: sample() then ends with that exception. But an exception
    // that end() throws while another one is being handled is lost.
};

// What a kernel was asked to do.
struct KernelWork {
    std::string name{};
    std::uint64_t launches = 0;
    std::uint64_t items = 0;  // work items in all launches
    // By the device's clock, where it has one and Observer::times_verbs() asks for times; else 0.
    double seconds = 0;
};

// What the host asked of a device. These numbers depend on the request and the backend, and hardly
// on the device, so that they can be compared where times cannot. 0 on backends without a device.
struct Work {
    std::uint64_t launches = 0;  // of kernels; a long one is launched in slices
    std::uint64_t waits = 0;     // of the host, until the device is idle
    std::uint64_t uploads = 0;
    std::uint64_t downloads = 0;
    std::uint64_t uploaded_bytes = 0;
    std::uint64_t downloaded_bytes = 0;
    std::vector<KernelWork> kernels{};  // in the order in which they were first launched
    Work& operator+=(const Work& other);
};

}  // namespace lacuna
