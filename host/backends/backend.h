// What a backend is: the verbs of a round, done in parallel on memory of its own.
#pragma once

#include <lacuna/lacuna.h>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/workers.h"
#include "plan/plan.h"
#include "rounds/round.h"

namespace lacuna {

// A copy of a backend's memory: what each verb reads and writes.
struct Snapshot {
    std::uint32_t capacity = 0;            // spans a line has room for before the backend grows
    std::vector<std::vector<Span>> spans;  // of each line: sorted, disjoint, none empty
    // Sorted by column, then y, then order; with a radius field by order alone.
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> statuses;  // of each candidate, see portable/status.h
    // In exact only.
    std::vector<Sample> grid;     // the sample of each grid cell, NO_SAMPLE where there is none
    std::uint32_t box_width = 0;  // of every box; 0 while the bins are lines
    // Line by line, none across the border between two rows of the grid. With a radius field by
    // region (plan/first_boxes.h), of any width.
    std::vector<Box> boxes;
    // In exact with a radius field, instead of the grid: those of earlier rounds, by x, then y.
    std::vector<Sample> samples;
    // In cells only: a bit for each lattice point, set while the point is free. Each line takes an
    // even number of words; its lowest y is the lowest bit of its first word.
    std::vector<std::uint32_t> bits;
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

// Serves one plan. A backend may queue the verbs and do them in finish_round. It may work in any
// order, but its results are exactly as in docs/design.md, sections 3 and 4:
//   locate    a draw becomes a candidate, whose y is found by walking along the bin's free length
//   admit     a candidate becomes a sample unless an earlier sample covers it: in lines a sample
//             of its round whose chord covers it on its own line; in exact any sample closer than
//             the radius; in cells a sample of its round with which it fails the metric
//   subtract  the chords of the round's samples are cut from the free spans of all lines
//   refine    exact only, in place of subtract from the first refinement on: spans become boxes,
//             with `halve` each box is halved in x, and all samples near a box cut it
// A plan's halo is never cut. Its lines stay whole; after the first refinement each line is a
// column of boxes, which end where rows of the sample grid do. So draws can be made there for
// samples of other ranks. If a round calls locate several times, the last call counts. Throws
// DeviceError, and Cancelled when the watch returns false.
template <typename Placed>
class BackendOf {
public:
    virtual ~BackendOf() = default;

    virtual std::string device() const = 0;
    virtual Work work() const { return {}; }
    // Memory for the draws of a round, from which locate reads them fastest. It may be empty, and
    // is valid until the next call.
    virtual std::span<Draw> room_for_draws(std::size_t) { return {}; }
    // The draws are sorted by bin, then rank. They must stay as they are until finish_round().
    virtual void locate(std::span<const Draw> draws) = 0;
    virtual void admit() = 0;
    virtual void subtract() = 0;
    virtual void refine(bool halve) = 0;
    virtual RoundOf<Placed> finish_round() = 0;

    // The host's threads, which the loop also uses to invert the cdf.
    virtual Workers& workers() = 0;

    // From now on each verb is complete when it returns, so that its time can be measured.
    virtual void time_verbs() {}

    // Long verbs ask may_go_on now and then, in the calling thread; false cancels the run.
    virtual void watch(std::function<bool()> may_go_on) = 0;
};

class Backend : public BackendOf<Sample> {
public:
    // The candidates of the last locate, in no particular order.
    virtual std::vector<Candidate> located() = 0;

    // For tests of single verbs; ranks, too, take snapshots. snapshot waits for the queued work.
    virtual Snapshot snapshot() = 0;
    virtual void restore(const Snapshot& snapshot) = 0;
};

// The same on surfaces and in volumes, for samples of space/portion.h.
namespace space {
struct SpaceSample;
using SpaceBackend = BackendOf<SpaceSample>;
}  // namespace space

// The device and the number of threads that the request asks for.
struct Placement {
    std::string device;
    std::uint32_t threads = 0;
};

}  // namespace lacuna
