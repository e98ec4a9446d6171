// Dart throwing in slabs.
#include "backends/cpu/darts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "backends/cpu/precedence.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

// Cells are asked for so many candidates ahead, and the candidates twice as many: what memory
// needs; 4 to 10 are alike.
constexpr std::size_t kAhead = 8;

constexpr std::size_t kPollEvery = std::size_t{1} << 14;  // candidates put off: some 2 ms

bool is_in(const Span& stretch, std::uint32_t x) {
    return x >= stretch.begin && x < stretch.end;
}

Sample place_of(const Candidate& candidate) {
    return {candidate.x, candidate.y};
}

}  // namespace

void screen(SpanState& state, std::uint32_t column) {
    const std::span<const Candidate> candidates = state.candidates_of(column);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate& later = candidates[std::min(k + kAhead, candidates.size() - 1)];
        state.grid->fetch_near(later.x, later.y);
        const std::size_t i = state.column_begins[column] + k;
        if (state.fates[i] == FATE_UNDECIDED &&
            state.grid->is_covered(candidates[k].x, candidates[k].y))
            state.fates[i] = FATE_COVERED;
    }
}

void Darts::begin(std::uint32_t begin, std::uint32_t end, std::uint32_t slabs) {
    begin_ = begin;
    end_ = end;
    put_off_.resize(slabs);
    for (std::vector<std::uint32_t>& of_slab : put_off_) of_slab.clear();
}

Darts::Slab Darts::slab_of(const SpanState& state, std::uint32_t index) const {
    const std::size_t slabs = put_off_.size();
    const std::size_t begin = index * std::size_t{state.columns} / slabs;
    const std::size_t end = (index + std::size_t{1}) * state.columns / slabs;
    const std::uint32_t first = state.column_begins[begin];
    constexpr std::uint32_t kBeyond = ~std::uint32_t{0};
    Slab slab{first, state.column_begins[end] - first, {0, kBeyond}, {0, kBeyond}};
    if (slabs == 1) return slab;
    const std::uint32_t side = state.plan.grid_side;
    const std::uint32_t width = state.plan.strip_width;
    slab.own.begin = (state.first_lines[begin] * width + side - 1) / side * side;
    slab.own.end = state.first_lines[end] * width / side * side;
    // A radius around x touches at most four columns of cells, from that of x - radius on.
    slab.inner.begin = slab.own.begin + state.plan.radius;
    slab.inner.end = slab.own.end - std::min(3 * side, slab.own.end) + state.plan.radius;
    return slab;
}

// The slab's candidates in their turns; and more entries, to be asked for ahead.
void Darts::list_turns(const SpanState& state, const Slab& slab, Scratch& scratch) const {
    auto& [thrown, starts, unsorted, sorted] = scratch;
    if (slabs() == 1) {
        thrown.resize(end_ - begin_);
        for (std::uint32_t turn = begin_; turn < end_; ++turn)
            thrown[turn - begin_] = candidate_of_turn(state.by_order, turn);
    } else {
        unsorted.clear();
        for (std::uint32_t i = slab.first; i < slab.first + slab.count; ++i) {
            const std::uint32_t turn = turn_of(state.candidates[i], i);
            if (turn - begin_ < end_ - begin_ && state.fates[i] != FATE_COVERED)
                unsorted.push_back({turn - begin_, i});
        }
        sort_turns(scratch);
    }
    thrown.resize(thrown.size() + 2 * kAhead, slab.first);
}

// By buckets of equally many turns, then among neighbours.
void Darts::sort_turns(Scratch& scratch) const {
    auto& [thrown, starts, unsorted, sorted] = scratch;
    const std::uint64_t count = unsorted.size();
    const auto bucket_of = [&](Turn turn) { return turn.number * count / (end_ - begin_); };
    starts.assign(count, 0);
    for (const Turn turn : unsorted) ++starts[bucket_of(turn)];
    std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), 0u);
    sorted.resize(count);
    for (const Turn turn : unsorted) sorted[starts[bucket_of(turn)]++] = turn;
    for (std::size_t i = 1; i < count; ++i) {
        const Turn moved = sorted[i];
        std::size_t to = i;
        for (; to > 0 && moved.number < sorted[to - 1].number; --to) sorted[to] = sorted[to - 1];
        sorted[to] = moved;
    }
    thrown.clear();
    for (const Turn turn : sorted) thrown.push_back(turn.candidate);
}

void Darts::throw_in(SpanState& state, std::uint32_t index) {
    thread_local Scratch of_thread;
    Scratch& scratch = of_thread;  // looked up once, see subtract.cpp
    const Slab slab = slab_of(state, index);
    if (slab.count == 0) return;
    list_turns(state, slab, scratch);
    const std::vector<std::uint32_t>& thrown = scratch.thrown;
    const bool is_shared = put_off_.size() > 1;
    SampleGrid& grid = *state.grid;
    for (std::size_t k = 0; k + 2 * kAhead < thrown.size(); ++k) {
        __builtin_prefetch(&state.candidates[thrown[k + 2 * kAhead]]);
        const Candidate& later = state.candidates[thrown[k + kAhead]];
        grid.fetch_near(later.x, later.y);
        const std::uint32_t i = thrown[k];
        const Sample place = place_of(state.candidates[i]);
        std::uint32_t& fate = state.fates[i];
        if (fate == FATE_ADMITTED) grid.insert(place);
        if (fate != FATE_UNDECIDED) continue;
        const bool is_inner = !is_shared || is_in(slab.inner, place.x);
        if (is_inner && grid.is_covered(place.x, place.y)) {
            fate = FATE_REJECTED;
        } else if (is_inner && (!is_shared || !grid.has_mark_near(place.x, place.y))) {
            fate = FATE_ADMITTED;
            grid.insert(place);
        } else {
            put_off_[index].push_back(i);
            if (is_in(slab.own, place.x)) grid.mark(place);
        }
    }
}

void Darts::finish(SpanState& state, const std::function<void()>& poll) {
    std::vector<std::uint32_t>& all = put_off_.front();
    for (std::size_t slab = 1; slab < put_off_.size(); ++slab)
        all.insert(all.end(), put_off_[slab].begin(), put_off_[slab].end());
    std::sort(all.begin(), all.end(), [&](std::uint32_t a, std::uint32_t b) {
        return precedes(state.candidates[a], state.candidates[b]);
    });
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k % kPollEvery == 0) poll();
        const std::uint32_t i = all[k];
        const Sample place = place_of(state.candidates[i]);
        const bool is_covered = state.grid->is_covered(place.x, place.y);
        state.fates[i] = is_covered ? FATE_REJECTED : FATE_ADMITTED;
        if (!is_covered) state.grid->insert(place);
    }
    for (const std::uint32_t i : all) state.grid->unmark(place_of(state.candidates[i]));
}

}  // namespace lacuna::cpu
