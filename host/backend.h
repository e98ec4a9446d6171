// What a backend is: the three verbs of a round, done in parallel on memory of its own.
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "plan.h"

namespace lacuna {

// One inversion of the cdf, with its place in the round: lower orders take precedence.
struct Draw {
    std::uint32_t line;
    std::uint32_t rank;  // along the line's free length
    std::uint32_t x;
    std::uint32_t order;
};

// A stretch of y on a line where a sample may still be placed, [begin, end).
struct Span {
    std::uint32_t begin;
    std::uint32_t end;
    friend bool operator==(const Span&, const Span&) = default;
};

// A draw with its y. An earlier sample covers it, or not, on its own line.
struct Candidate {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t line;
    std::uint32_t order;
    friend bool operator==(const Candidate&, const Candidate&) = default;
};

// A backend's memory, laid open: what each verb reads and what it leaves behind.
struct Snapshot {
    std::uint32_t capacity;                // spans a line has room for before the backend grows
    std::vector<std::vector<Span>> spans;  // of each line: sorted, disjoint, none empty
    std::vector<Candidate> candidates;     // column by column, by y, then order, within a column
    std::vector<std::uint32_t> fates;      // of each candidate, see portable/fate.h
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

// What a round hands back. Valid until the backend's next call.
struct Round {
    std::span<const Sample> samples;              // admitted, in the order of their draws
    std::span<const std::uint32_t> free_lengths;  // of every line, after the subtraction
};

// Serves one plan. A backend may queue the verbs and do them at finish_round. Whatever the order
// of its work, the outcome is that of DESIGN section 3, whole number for whole number:
//   locate    a draw becomes a candidate: its rank is walked to a y through the line's free spans
//   admit     a candidate becomes a sample unless an earlier sample of the round covers it, with
//             its chord on the candidate's own line
//   subtract  the chords of the round's samples are cut from the free spans of all lines
// Throws DeviceError.
class Backend {
public:
    virtual ~Backend() = default;

    virtual std::string device() const = 0;
    virtual void locate(std::span<const Draw> draws) = 0;  // sorted by line
    virtual void admit() = 0;
    virtual void subtract() = 0;
    virtual Round finish_round() = 0;

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
