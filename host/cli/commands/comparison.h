// One request on several backends and devices: whether they agree, and what each costs.
#pragma once

#include <lacuna/lacuna.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/terminal/stopwatch.h"

namespace lacuna::cli {

// What makes the sets: lacuna::sample, but in tests of what becomes of a wrong one.
using Sampler = std::function<Result(const Request&, Observer&)>;

// Why a backend that this build has lists no device.
inline constexpr const char* kNoDriver = "no driver for it is installed";

// A place to run on. One that cannot be run on says why.
struct Contestant {
    std::string backend;
    std::string device;  // a number, as Request::device takes it; empty where there is only one
    std::string name;    // of the device
    std::string missing;
};

// Every device of the backends named, in the order named; without names of cpu, opencl and vulkan.
// Throws BadRequest for an unknown name, and Unavailable for a backend that is named and missing.
std::vector<Contestant> find_contestants(const std::vector<std::string>& backends);

// The first point that is not the same. One is missing where the other set goes on.
struct Difference {
    std::size_t index;
    std::optional<Point> expected;
    std::optional<Point> got;
};

// What a contestant's runs came to.
struct Entry {
    Contestant contestant;
    std::string failure;     // why it has no more runs; or empty
    bool broke_off = false;  // it failed at work; otherwise it could not begin
    std::string device;      // as the result names it
    std::size_t points = 0;  // of the first run, as all below
    std::uint64_t rounds = 0;
    std::string sha256;
    // By how much the first run, which counts in no other time, took longer than the median:
    // finding devices, building kernels, some of which drivers build only when they are first
    // launched.
    double first_run_seconds = 0;
    double first_use_seconds() const;
    std::optional<std::uint64_t> memory_bytes;  // by how much it raised the program's peak
    std::vector<double> seconds;                // of each run but the first
    std::vector<std::array<double, kVerbs.size()>> verb_seconds;  // likewise
    // From the yardstick, in the first run in which there is any.
    std::optional<Difference> difference;

    bool has_run() const { return !seconds.empty(); }
    double median_seconds() const;
    double median_seconds(std::size_t verb) const;  // by its place in kVerbs
};

struct Comparison {
    std::vector<Entry> entries;
    double radius = 0;
    double scale = 0;  // in cells

    // The first entry with runs, which the others are measured by. Null when none has any.
    const Entry* yardstick() const;
    // Whether every run of every entry made the yardstick's points.
    bool agree() const;
};

// Runs the contestants in turn, so many times and once before, so that they share what the machine
// goes through.
// Those that are missing, or fail, keep the reason. Throws what the sampler throws for a request
// that cannot be met, and Cancelled.
Comparison compare(const Request& request, const std::vector<Contestant>& contestants,
                   std::uint32_t runs, const Sampler& sampler, Observer& observer);

}  // namespace lacuna::cli
