// Dart throwing in slabs.
#include "backends/cpu/darts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "backends/cpu/precedence.h"
#include "base/insertion_sort.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// Prefetch distance of cells, in candidates; candidates are prefetched twice as far ahead.
// Distances of 4 to 10 were equally fast.
constexpr std::size_t kAhead = 8;

constexpr std::size_t kPollEvery = std::size_t{1} << 14;  // in candidates put off: some 2 ms

bool is_in(const Span& stretch, std::uint32_t x) {
    return x >= stretch.begin && x < stretch.end;
}

// The candidates of a slab; the slabs divide the columns evenly.
void find_candidates(const SpanState& state, std::uint32_t index, std::size_t slabs,
                     std::vector<Span>& found) {
    found = {{state.column_begins[index * std::size_t{state.columns} / slabs],
              state.column_begins[(index + std::size_t{1}) * state.columns / slabs]}};
}
// The same with a radius field: a slab is a zone.
void find_candidates(const FieldState& state, std::uint32_t index, std::size_t,
                     std::vector<Span>& found) {
    found.clear();
    for (const std::uint32_t region : state.first.zones[index].regions)
        found.push_back({state.column_begins[region], state.column_begins[region + 1]});
}

// What darts are thrown at with one radius: the sample grid. A slab decides the candidates whose x
// lies in inner_: they read only cells whose x lies in own_, which no other slab changes.
class GridBoard {
public:
    explicit GridBoard(SpanState& state)
        : grid_(*state.grid), own_{0, kBeyond}, inner_{0, kBeyond} {}
    GridBoard(SpanState& state, std::uint32_t index, std::size_t slabs) : GridBoard(state) {
        if (slabs == 1) return;
        const std::size_t begin = index * std::size_t{state.columns} / slabs;
        const std::size_t end = (index + std::size_t{1}) * state.columns / slabs;
        const std::uint32_t side = state.plan.grid().side;
        const std::uint32_t width = state.plan.strip_width;
        own_.begin = (state.first_lines[begin] * width + side - 1) / side * side;
        own_.end = state.first_lines[end] * width / side * side;
        // A disk around x touches at most four columns of cells; the first contains x - radius.
        inner_.begin = own_.begin + state.plan.radius;
        inner_.end = own_.end - std::min(3 * side, own_.end) + state.plan.radius;
    }

    void fetch(const Candidate& later) const { grid_.fetch_near(later.x, later.y); }
    void fetch_sooner(const Candidate&) const {}
    bool may_settle(const Candidate& candidate) const { return is_in(inner_, candidate.x); }
    bool is_covered(const Candidate& candidate) const {
        return grid_.is_covered(candidate.x, candidate.y);
    }
    bool has_mark_near(const Candidate& candidate) const {
        return grid_.has_mark_near(candidate.x, candidate.y);
    }
    void insert(const Candidate& candidate) { grid_.insert({candidate.x, candidate.y}); }
    void mark(const Candidate& candidate) {
        if (is_in(own_, candidate.x)) grid_.mark({candidate.x, candidate.y});
    }
    void unmark_all(std::span<const Candidate> candidates, std::span<const std::uint32_t> put_off) {
        for (const std::uint32_t i : put_off) grid_.unmark({candidates[i].x, candidates[i].y});
    }

private:
    static constexpr std::uint32_t kBeyond = ~std::uint32_t{0};

    SampleGrid& grid_;
    Span own_;
    Span inner_;
};

// The same with a radius field: the neighbour lists. A slab is a zone, and decides the candidates
// whose disk lies in it: no conflict is farther away than a candidate's own radius, times the
// greatest factor of its class.
class ListBoard {
public:
    explicit ListBoard(FieldState& state) : state_(state), sheets_(state.plan.field().sheets) {}
    ListBoard(FieldState& state, std::uint32_t index, std::size_t slabs) : ListBoard(state) {
        if (slabs == 1) return;
        index_ = index;
        zone_ = &state.first.zones[index];
    }

    void fetch(const Candidate& later) const {
        state_.near.fetch_list(later.line);
        state_.near.fetch_way_to_node(later.line);
    }
    void fetch_sooner(const Candidate& later) const { state_.near.fetch_node(later.line); }
    bool may_settle(const Candidate& at) const {
        if (zone_ == nullptr) return true;
        const Box& own = state_.first.nodes[zone_->nodes.front()].box;
        const std::uint32_t reach =
            portable::times_factor(radius_of(at), sheets_.greatest_factor(sheets_.of(at.x)));
        const std::uint32_t x = sheets_.x_on_sheet(at.x);
        const std::uint32_t own_x = sheets_.x_on_sheet(own.x);
        return x - own_x >= reach && own_x + own.width - x > reach && at.y - own.begin >= reach &&
               own.end - at.y > reach;
    }
    bool is_covered(const Candidate& candidate) const {
        const std::uint32_t radius = radius_of(candidate);
        return radius == 0 ||
               state_.near.is_any_closer(candidate.line, {candidate.x, candidate.y}, radius);
    }
    bool has_mark_near(const Candidate& candidate) const {
        return state_.near.is_marked(candidate.line);
    }
    void insert(const Candidate& candidate) {
        // A candidate that the slab could not decide may reach beyond the zone.
        state_.near.insert(sized(candidate), candidate.line,
                           may_settle(candidate) ? zone_ : nullptr);
    }
    void mark(const Candidate& candidate) { state_.near.mark(sized(candidate), index_); }
    void unmark_all(std::span<const Candidate>, std::span<const std::uint32_t>) {
        state_.near.unmark_all();
    }

private:
    std::uint32_t radius_of(const Candidate& candidate) const {
        return state_.radius_field.radius_at(candidate.x, candidate.y);
    }

    Sized sized(const Candidate& candidate) const {
        return {candidate.x, candidate.y, radius_of(candidate)};
    }

    FieldState& state_;
    const Sheets& sheets_;
    std::uint32_t index_ = 0;
    const FirstBoxes::Zone* zone_ = nullptr;  // null: all of the domain
};

template <typename... Slab>
GridBoard board_of(SpanState& state, Slab... slab) {
    return GridBoard(state, slab...);
}
template <typename... Slab>
ListBoard board_of(FieldState& state, Slab... slab) {
    return ListBoard(state, slab...);
}

template <typename DartState>
void screen_column(DartState& state, std::uint32_t column) {
    const std::span<const Candidate> candidates = state.candidates_of(column);
    const auto board = board_of(state);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        board.fetch(candidates[std::min(k + kAhead, candidates.size() - 1)]);
        const std::size_t i = state.column_begins[column] + k;
        if (state.statuses[i] == STATUS_UNDECIDED && board.is_covered(candidates[k]))
            state.statuses[i] = STATUS_COVERED;
    }
}

}  // namespace

void screen(SpanState& state, std::uint32_t column) {
    screen_column(state, column);
}
void screen(FieldState& state, std::uint32_t region) {
    screen_column(state, region);
}

void Darts::begin(std::uint32_t begin, std::uint32_t end, std::uint32_t slabs) {
    begin_ = begin;
    end_ = end;
    put_off_.resize(slabs);
    for (std::vector<std::uint32_t>& of_slab : put_off_) of_slab.clear();
}

// Lists the slab's candidates in the order of their turns, then entries that are only prefetched.
void Darts::list_turns(const State& state, Scratch& scratch) const {
    auto& [thrown, candidates, starts, unsorted, sorted] = scratch;
    if (slabs() == 1) {
        thrown.resize(end_ - begin_);
        for (std::uint32_t turn = begin_; turn < end_; ++turn)
            thrown[turn - begin_] = candidate_of_turn(state.by_order, turn);
    } else {
        unsorted.clear();
        for (const Span& run : candidates)
            for (std::uint32_t i = run.begin; i < run.end; ++i) {
                const std::uint32_t turn = turn_of(state.candidates[i], i);
                if (turn - begin_ < end_ - begin_ && state.statuses[i] != STATUS_COVERED)
                    unsorted.push_back({turn - begin_, i});
            }
        sort_turns(scratch);
    }
    thrown.resize(thrown.size() + 2 * kAhead, 0);
}

// Sorts into buckets of equally many turns first, then by insertion.
void Darts::sort_turns(Scratch& scratch) const {
    auto& [thrown, candidates, starts, unsorted, sorted] = scratch;
    const std::uint64_t count = unsorted.size();
    const auto bucket_of = [&](Turn turn) { return turn.number * count / (end_ - begin_); };
    starts.assign(count, 0);
    for (const Turn turn : unsorted) ++starts[bucket_of(turn)];
    std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), 0u);
    sorted.resize(count);
    for (const Turn turn : unsorted) sorted[starts[bucket_of(turn)]++] = turn;
    insertion_sort(std::span(sorted), [](Turn a, Turn b) { return a.number < b.number; });
    thrown.clear();
    for (const Turn turn : sorted) thrown.push_back(turn.candidate);
}

template <typename DartState>
void Darts::throw_in(DartState& state, std::uint32_t index) {
    thread_local Scratch of_thread;
    Scratch& scratch = of_thread;  // looked up once, see subtract.cpp
    if (slabs() > 1) find_candidates(state, index, put_off_.size(), scratch.candidates);
    list_turns(state, scratch);
    const std::vector<std::uint32_t>& thrown = scratch.thrown;
    auto board = board_of(state, index, put_off_.size());
    const bool is_shared = put_off_.size() > 1;
    for (std::size_t k = 0; k + 2 * kAhead < thrown.size(); ++k) {
        __builtin_prefetch(&state.candidates[thrown[k + 2 * kAhead]]);
        board.fetch(state.candidates[thrown[k + kAhead]]);
        board.fetch_sooner(state.candidates[thrown[k + kAhead / 2]]);
        const std::uint32_t i = thrown[k];
        const Candidate& candidate = state.candidates[i];
        std::uint32_t& status = state.statuses[i];
        if (status == STATUS_ADMITTED) board.insert(candidate);
        if (status != STATUS_UNDECIDED) continue;
        const bool is_inner = board.may_settle(candidate);
        if (is_inner && board.is_covered(candidate)) {
            status = STATUS_REJECTED;
        } else if (is_inner && (!is_shared || !board.has_mark_near(candidate))) {
            status = STATUS_ADMITTED;
            board.insert(candidate);
        } else {
            put_off_[index].push_back(i);
            board.mark(candidate);
        }
    }
}

template <typename DartState>
void Darts::finish(DartState& state, const std::function<void()>& poll) {
    std::vector<std::uint32_t>& all = put_off_.front();
    for (std::size_t slab = 1; slab < put_off_.size(); ++slab)
        all.insert(all.end(), put_off_[slab].begin(), put_off_[slab].end());
    std::sort(all.begin(), all.end(), [&](std::uint32_t a, std::uint32_t b) {
        return precedes(state.candidates[a], state.candidates[b]);
    });
    auto board = board_of(state);
    const auto later = [&](std::size_t k) {
        return state.candidates[all[std::min(k, all.size() - 1)]];
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k % kPollEvery == 0) poll();
        board.fetch(later(k + kAhead));
        board.fetch_sooner(later(k + kAhead / 2));
        const std::uint32_t i = all[k];
        const bool is_covered = board.is_covered(state.candidates[i]);
        state.statuses[i] = is_covered ? STATUS_REJECTED : STATUS_ADMITTED;
        if (!is_covered) board.insert(state.candidates[i]);
    }
    board.unmark_all(state.candidates, all);
}

template void Darts::throw_in(SpanState&, std::uint32_t);
template void Darts::throw_in(FieldState&, std::uint32_t);
template void Darts::finish(SpanState&, const std::function<void()>&);
template void Darts::finish(FieldState&, const std::function<void()>&);

}  // namespace lacuna::cpu
