// Makes sets of one request with many seeds, several at once, and tracks the progress.
#pragma once

#include <lacuna/lacuna.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "reproduce/reproduce.h"

namespace lacuna::reproduce {

// The work that is done of a total, in any unit. Several threads may use one object.
class Work {
public:
    Work(const Setting& setting, double total) : setting_(setting), total_(total) {}

    // Adds finished work. Throws Cancelled.
    void add(double done);
    // Returns false when the work must end.
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
    std::vector<double> seconds;  // for each set, by one thread

    double mean_count() const;
    double mean_seconds() const;
};

// Makes sets with the seeds first_seed, first_seed + 1, ... Each is made by one thread, with one
// thread on each core. Each adds `cost` to the work. The points do not depend on the number of
// cores. Throws as sample() does.
Sets make_sets(const Request& request, std::uint32_t runs, Work& work, double cost = 1);

// The same with dart throwing: the first `count` darts that are kept.
Sets throw_sets(const Request& request, std::uint64_t count, std::uint32_t runs, Work& work,
                double cost = 1);

// The request that agrees with the paper's tables: mode lines on the unit square, x on the lines.
Request lines_request(double radius, Boundary boundary);

}  // namespace lacuna::reproduce
