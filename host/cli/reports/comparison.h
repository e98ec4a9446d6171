// One request on several backends and devices: whether the points agree, and times and memory.
#pragma once

#include <lacuna/lacuna.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/terminal/observers.h"
#include "files/medium.h"

namespace lacuna::cli {

// The function that makes the sets: lacuna::sample. Tests use others, which make wrong sets.
using Sampler = std::function<Result(const Request&, Observer&)>;

// The reason if a backend of this build lists no device.
inline constexpr const char* kNoDriver = "no driver for it is installed";

// A device of a backend.
struct Contestant {
    std::string backend;
    std::string device;   // its number, for Place::device; empty if it is the only one
    std::string name;     // of the device
    std::string missing;  // why it cannot be used; empty if it can
};

// Every device of the backends named, in the order named; without names every device of cpu, opencl
// and vulkan. Throws BadRequest for an unknown name, and Unavailable if a named backend is missing.
std::vector<Contestant> find_contestants(const std::vector<std::string>& backends);

// The first point that differs. If one set is shorter, its point is unset.
struct Difference {
    std::size_t index;
    std::optional<Point> expected;
    std::optional<Point> got;
};

// The results of a contestant's runs.
struct Entry {
    Contestant contestant;
    std::string failure;     // why runs are missing, or empty
    bool broke_off = false;  // true if it failed at work, false if it could not begin
    std::string device;      // as the result names it
    // From here to `work` all is of the first run.
    std::size_t points = 0;
    std::uint64_t rounds = 0;
    std::string sha256;
    double first_run_seconds = 0;
    // By how much the first run took longer than the median of the others: it finds devices and
    // builds kernels, some of which drivers build only at their first launch.
    double first_use_seconds() const;
    std::optional<std::uint64_t> memory_bytes;  // by how much it raised the program's peak
    Work work;  // of a device, while it places the points; the seconds are of the last run
    std::vector<double> seconds;  // of each run except the first and the last
    // Of the last run, in which devices wait for each verb, and measure each kernel.
    std::array<double, kVerbs.size()> verb_seconds{};  // by index into kVerbs
    // From the yardstick, in the first run that differs from it.
    std::optional<Difference> difference;

    bool has_run() const { return !seconds.empty(); }
    double median_seconds() const;
    void take_seconds_of_kernels(const Work& timed);
};

struct Comparison {
    std::vector<Entry> entries;
    double radius = 0;
    double scale = 0;  // in cells

    // The first entry with runs, with which the others are compared. Null if no entry has runs.
    const Entry* yardstick() const;
    // Whether every run of every entry made the same points as the yardstick.
    bool agree() const;
};

// Runs every contestant 2 + `runs` times. They take turns, so that a busy machine slows all alike.
// Contestants that are missing or fail keep the reason. Throws what the sampler throws for a
// request that cannot be met, and Cancelled.
Comparison compare(const Request& request, const std::vector<Contestant>& contestants,
                   std::uint32_t runs, const Sampler& sampler, Observer& observer);

// A table of times, memory and agreement, a table of seconds by verb, and then the hash of the
// points and the differences.
std::string text_of(const Comparison& comparison);

// Tables of what each device was asked to do in a round, in all and by each kernel. Empty if no
// device took part.
std::string work_text(const Comparison& comparison);

// The same as JSON, with the seconds of every run.
std::string json_of(const Comparison& comparison, const Request& request);

// A bar for each entry's median, divided into its verbs, and a line from fastest to slowest run.
std::string draw_chart(const Comparison& comparison, files::Medium medium);

}  // namespace lacuna::cli
