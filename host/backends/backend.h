// What a backend is: the verbs of a round, done in parallel on memory of its own.
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/workers.h"
#include "plan/plan.h"

namespace lacuna {

// One inversion of the cdf, with its turn in the round: lower orders take precedence. Its place is
// a line or, after the first refinement, a box.
struct Draw {
    std::uint32_t place;
    std::uint32_t rank;    // along the place's free length
    std::uint32_t offset;  // from the place's low x
    std::uint32_t order;
    friend bool operator==(const Draw&, const Draw&) = default;
};

// What a refinement leaves of a strip's free spans: [x, x + width) times [begin, end), all of one
// width. None crosses the border of a row of the sample grid.
struct Box {
    std::uint32_t x;
    std::uint32_t begin;
    std::uint32_t end;
    friend bool operator==(const Box&, const Box&) = default;
};

// A draw with its y. With a radius field its line is 0.
struct Candidate {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t line;  // whose strip it lies in
    std::uint32_t order;
    friend bool operator==(const Candidate&, const Candidate&) = default;
};

// A backend's memory, laid open: what each verb reads and what it leaves behind.
struct Snapshot {
    std::uint32_t capacity = 0;            // spans a line has room for before the backend grows
    std::vector<std::vector<Span>> spans;  // of each line: sorted, disjoint, none empty
    std::vector<Candidate> candidates;     // column by column, by y, then order, within a column
    std::vector<std::uint32_t> statuses;   // of each candidate, see portable/status.h
    // In exact only.
    std::vector<Sample> grid;     // the sample of each grid cell, NO_SAMPLE where there is none
    std::uint32_t box_width = 0;  // 0: lines are drawn from, not boxes
    std::vector<Box> boxes;       // line by line
    // In exact with a radius field, instead: region by region, see plan/first_boxes.h.
    std::vector<Rectangle> rectangles;
    std::vector<Sample> samples;  // of earlier rounds, by x, then y
    // In cells only: a bit for each lattice point, set while it is free. Line by line, each in an
    // even number of words, the lowest y in the lowest bit of the first.
    std::vector<std::uint32_t> bits;
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

// What a round hands back. Valid until the backend's next call.
struct Round {
    std::span<const Sample> samples;                 // admitted, in the order of their draws
    std::uint64_t survivors;                         // draws free of the samples of earlier rounds
    std::span<const std::uint32_t> free_lengths;     // of every place, after the round
    std::uint32_t bin_width;                         // of every place, unless
    std::span<const std::uint32_t> bin_widths = {};  // tells that of each
    // Where the plan tells orders: that of each sample's draw. In lines and exact without a radius
    // field: the first box of each column, then the number of places.
    std::span<const std::uint32_t> orders = {};
    std::span<const std::uint32_t> bin_begins = {};
};

// Serves one plan. A backend may queue the verbs and do them at finish_round. Whatever the order
// of its work, the outcome is that of docs/design.md, sections 3 and 4, whole number for whole
// number:
//   locate    a draw becomes a candidate: its rank is walked to a y through its place's free length
//   admit     a candidate becomes a sample unless an earlier sample covers it. In lines: one of the
//             round, with its chord on the candidate's own line. In exact: any sample closer than
//             the radius, of the round or of an earlier one.
//   subtract  the chords of the round's samples are cut from the free spans of all lines
//   refine    exact only, in place of subtract and then for good: spans become boxes, boxes are cut
//             by all samples near them; with `halve`, into two of half the width first
// A plan's halo is never cut: its places are its lines, whole, and from the first refinement on
// each of them in boxes that end where rows of the sample grid do. So draws can be made that put
// samples of others there. Of several locates in a round the last one counts.
// Throws DeviceError, and Cancelled when a watch says so.
class Backend {
public:
    virtual ~Backend() = default;

    virtual std::string device() const = 0;
    virtual void locate(std::span<const Draw> draws) = 0;  // sorted by place, then rank
    virtual void admit() = 0;
    virtual void subtract() = 0;
    virtual void refine(bool halve) = 0;
    virtual Round finish_round() = 0;

    // What the last locate made of its draws, in no particular order.
    virtual std::vector<Candidate> located() = 0;

    // Threads of the host, which also serve what a round has to do before the verbs.
    virtual Workers& workers() = 0;

    // Asked now and then during long verbs, from the calling thread; false cancels the run.
    virtual void watch(std::function<bool()> may_go_on) = 0;

    // Waits for what is queued. For tests, which set the scene for one verb and look at what it
    // leaves; the loop never needs them.
    virtual Snapshot snapshot() = 0;
    virtual void restore(const Snapshot& snapshot) = 0;
};

// Where the request asks for it to run.
struct Placement {
    std::string device;
    std::uint32_t threads = 0;
};

}  // namespace lacuna
