// Many sets of one request, seed by seed, several at once, and how much of all work is done.
#pragma once

#include <lacuna/lacuna.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "reproduce/reproduce.h"

namespace lacuna::reproduce {

// How much is done of a total, in any unit. Threads may share one.
class Work {
public:
    Work(const Setting& setting, double total) : setting_(setting), total_(total) {}

    // Throws Cancelled.
    void add(double done);
    // False once the work is to end.
    bool keep_going();

private:
    const Setting& setting_;
    double total_;
    double done_ = 0;
    std::mutex mutex_;
    std::atomic<bool> cancelled_ = false;
};

struct Sets {
    std::vector<std::vector<Point>> points;
    std::vector<double> seconds;  // of each set, made by one thread

    double mean_count() const;
    double mean_seconds() const;
};

// The sets of the seeds first_seed, first_seed + 1, ..., each by one thread, as many at once as
// there are cores; `cost` is what each adds to what is done. The points do not depend on the number
// of cores. Throws as sample() does.
Sets make_sets(const Request& request, std::uint32_t runs, Work& work, double cost = 1);

// The first `count` darts that stick of dart throwing, likewise.
Sets throw_sets(const Request& request, std::uint64_t count, std::uint32_t runs, Work& work,
                double cost = 1);

// A request in mode lines on the unit square, as the paper's tables agree with: on the lines.
Request lines_request(double radius, Boundary boundary);

}  // namespace lacuna::reproduce
