// admit in exact: the round's draws are thrown like darts, one after another, at the samples.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "backends/cpu/neighbour_lists.h"
#include "backends/cpu/round_memory.h"
#include "backends/cpu/sample_grid.h"
#include "base/workers.h"

namespace lacuna::cpu {

// Several threads each serve slabs. A slab is a run of columns or, with a radius field, a zone
// (plan/first_boxes.h).
// It decides a candidate at once if everything that could conflict with it lies in the slab. Other
// candidates are put off: each leaves a mark in its cell, and a later candidate near a mark is put
// off too. When all slabs are done, one thread decides the candidates that were put off. So a draw
// is decided after all earlier draws that it could conflict with, as if all were thrown in their
// order. In slabs of c columns, about 2 / c of the draws are put off.
class Darts {
public:
    // Index is SampleGrid or NeighbourLists. Decides the round's candidates, and puts its samples
    // into the index.
    template <typename Index>
    void throw_all(Index& index, RoundMemory& round, Workers& workers);

    // The steps of throw_all. Takes draws [begin, end), by order. Call throw_in for each slab, in
    // parallel, then finish.
    void begin(std::uint32_t begin, std::uint32_t end, std::uint32_t slabs);
    std::uint32_t slabs() const { return static_cast<std::uint32_t>(put_off_.size()); }
    template <typename Index>
    void throw_in(Index& index, RoundMemory& round, std::uint32_t slab);
    // Decides what was put off. Calls poll now and then, which may throw.
    template <typename Index>
    void finish(Index& index, RoundMemory& round, const std::function<void()>& poll);

private:
    struct Turn {
        std::uint32_t number;
        std::uint32_t candidate;
    };
    // A thread's memory, reused from slab to slab.
    struct Scratch {
        std::vector<std::uint32_t> thrown;  // candidates in the order of their turns
        std::vector<Span> candidates;       // of the slab
        std::vector<std::uint32_t> starts;
        std::vector<Turn> unsorted;
        std::vector<Turn> sorted;
    };
    void list_turns(const RoundMemory& round, Scratch& scratch) const;
    void sort_turns(Scratch& scratch) const;

    std::uint32_t begin_ = 0;
    std::uint32_t end_ = 0;
    std::vector<std::vector<std::uint32_t>> put_off_;  // of each slab, in the order of turns
};

// Gives the column's undecided candidates that samples of earlier rounds cover STATUS_COVERED.
template <typename Index>
void screen(Index& index, RoundMemory& round, std::uint32_t column);

}  // namespace lacuna::cpu
