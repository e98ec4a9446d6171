// admit in exact: the round's draws are thrown like darts, one after another, at the sample grid.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "backends/cpu/field_state.h"
#include "backends/cpu/state.h"

namespace lacuna::cpu {

// Draws take their turns in slabs, runs of columns that several threads serve at once. A slab
// settles a candidate where all that could conflict with it lies in the slab, in cells of its own.
// Others are put off, and so is what comes later and might conflict with one put off, for each of
// those leaves a mark in its cell. When all slabs are done, those put off take their turns, in one
// thread. So every draw is settled after all earlier ones that it could conflict with, as if all
// were thrown in their order. In slabs of c columns, some 2 draws in c are put off. With a radius
// field each region is a slab.
class Darts {
public:
    // Turns [begin, end) of the round, in so many slabs: throw_in each, in parallel, then finish.
    void begin(std::uint32_t begin, std::uint32_t end, std::uint32_t slabs);
    std::uint32_t slabs() const { return static_cast<std::uint32_t>(put_off_.size()); }
    template <typename DartState>  // SpanState or FieldState
    void throw_in(DartState& state, std::uint32_t slab);
    // Calls poll now and then, which may throw.
    template <typename DartState>
    void finish(DartState& state, const std::function<void()>& poll);

private:
    struct Turn {
        std::uint32_t number;
        std::uint32_t candidate;
    };
    // What a thread keeps from slab to slab.
    struct Scratch {
        std::vector<std::uint32_t> thrown;  // candidates, in their turns
        std::vector<std::uint32_t> starts;
        std::vector<Turn> unsorted;
        std::vector<Turn> sorted;
    };
    void list_turns(const State& state, Span slab, Scratch& scratch) const;
    void sort_turns(Scratch& scratch) const;

    std::uint32_t begin_ = 0;
    std::uint32_t end_ = 0;
    std::vector<std::vector<std::uint32_t>> put_off_;  // of each slab: candidates, by their turns
};

}  // namespace lacuna::cpu
