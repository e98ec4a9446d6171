// Dart throwing in slabs.
#include "backends/cpu/darts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "backends/cpu/precedence.h"
#include "base/insertion_sort.h"
#include "portable/column.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// Prefetch distance of cells, in candidates; candidates are prefetched twice as far ahead.
// Distances of 4 to 10 were equally fast.
constexpr std::size_t kAhead = 8;

// Draws per slab between two chances to cancel the run: they take some 0.02 s.
constexpr std::uint32_t kTurnsAtOnce = std::uint32_t{1} << 17;
// Fewer draws take one thread less time than it takes to divide them among slabs.
constexpr std::uint32_t kDrawsWorthSlabs = 4096;

constexpr std::size_t kPollEvery = std::size_t{1} << 14;  // in candidates put off: some 2 ms

// What darts are thrown at with one radius: the sample grid. A slab is a run of columns, and
// decides the candidates whose x lies in inner_: they read only cells whose x lies in own_, which
// no other slab changes.
class GridBoard {
public:
    explicit GridBoard(SampleGrid& grid) : grid_(grid) {}
    GridBoard(SampleGrid& grid, const RoundMemory& round, std::uint32_t slab, std::size_t slabs)
        : grid_(grid) {
        if (slabs == 1) return;
        const Plan& plan = round.plan;
        const auto column_at = [&](std::size_t border) {
            return static_cast<std::uint32_t>(border * round.columns / slabs);
        };
        const auto x_of = [&](std::uint32_t column) {
            return plan.strip_width *
                   portable::first_line_of_column(column, plan.lines, round.columns);
        };
        columns_ = {column_at(slab), column_at(slab + std::size_t{1})};
        const std::uint32_t side = plan.grid().side;
        own_.begin = (x_of(columns_.begin) + side - 1) / side * side;
        own_.end = x_of(columns_.end) / side * side;
        // A disk around x touches at most four columns of cells; the first contains x - radius.
        inner_.begin = own_.begin + plan.radius;
        inner_.end = own_.end - std::min(3 * side, own_.end) + plan.radius;
    }

    // In narrower slabs too many draws are put off; the cells of wider ones do not stay in a core's
    // cache. Slabs of 64 columns were the fastest at 8 million points. A single thread uses slabs
    // as well, for the cache's sake.
    static std::uint32_t most_slabs(const SampleGrid&, const RoundMemory& round) {
        return std::clamp(round.columns / 64, 1u, 1024u);
    }
    // The slab's candidates, in runs.
    void find_candidates(const RoundMemory& round, std::vector<Span>& found) const {
        found = {{round.column_begins[columns_.begin], round.column_begins[columns_.end]}};
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
    void insert(const Candidate& candidate) { grid_.insert(candidate); }
    void mark(const Candidate& candidate) {
        if (is_in(own_, candidate.x)) grid_.mark({candidate.x, candidate.y});
    }
    void unmark_all(std::span<const Candidate> candidates, std::span<const std::uint32_t> put_off) {
        for (const std::uint32_t i : put_off) grid_.unmark({candidates[i].x, candidates[i].y});
    }

private:
    static bool is_in(const Span& stretch, std::uint32_t x) {
        return x >= stretch.begin && x < stretch.end;
    }

    SampleGrid& grid_;
    Span columns_{0, 0};
    Span own_{0, ~std::uint32_t{0}};
    Span inner_{0, ~std::uint32_t{0}};
};

// The same with a radius field: the neighbour lists. A slab is a zone, and decides the candidates
// whose disk lies in it: no conflict is farther away than a candidate's own radius, times the
// greatest factor of its class.
class ListBoard {
public:
    explicit ListBoard(NeighbourLists& lists)
        : lists_(lists), sheets_(lists.plan().field().sheets) {}
    ListBoard(NeighbourLists& lists, const RoundMemory&, std::uint32_t slab, std::size_t slabs)
        : ListBoard(lists) {
        if (slabs == 1) return;
        index_ = slab;
        zone_ = &lists.first().zones[slab];
    }

    static std::uint32_t most_slabs(const NeighbourLists& lists, const RoundMemory&) {
        return std::max(1u, static_cast<std::uint32_t>(lists.first().zones.size()));
    }
    void find_candidates(const RoundMemory& round, std::vector<Span>& found) const {
        found.clear();
        for (const std::uint32_t region : zone_->regions)
            found.push_back({round.column_begins[region], round.column_begins[region + 1]});
    }

    void fetch(const Candidate& later) const {
        lists_.fetch_list(later.line);
        lists_.fetch_way_to_node(later.line);
    }
    void fetch_sooner(const Candidate& later) const { lists_.fetch_node(later.line); }
    bool may_settle(const Candidate& at) const {
        if (zone_ == nullptr) return true;
        const Box& own = lists_.first().nodes[zone_->nodes.front()].box;
        const std::uint32_t reach = portable::times_factor(
            lists_.sized(at).radius, sheets_.greatest_factor(sheets_.of(at.x)));
        const std::uint32_t x = sheets_.x_on_sheet(at.x);
        const std::uint32_t own_x = sheets_.x_on_sheet(own.x);
        return x - own_x >= reach && own_x + own.width - x > reach && at.y - own.begin >= reach &&
               own.end - at.y > reach;
    }
    bool is_covered(const Candidate& candidate) const {
        const std::uint32_t radius = lists_.sized(candidate).radius;
        return radius == 0 ||
               lists_.is_any_closer(candidate.line, {candidate.x, candidate.y}, radius);
    }
    bool has_mark_near(const Candidate& candidate) const {
        return lists_.is_marked(candidate.line);
    }
    void insert(const Candidate& candidate) {
        // A candidate that the slab could not decide may reach beyond the zone.
        lists_.insert(lists_.sized(candidate), candidate.line,
                      may_settle(candidate) ? zone_ : nullptr);
    }
    void mark(const Candidate& candidate) { lists_.mark(lists_.sized(candidate), index_); }
    void unmark_all(std::span<const Candidate>, std::span<const std::uint32_t>) {
        lists_.unmark_all();
    }

private:
    NeighbourLists& lists_;
    const Sheets& sheets_;
    std::uint32_t index_ = 0;
    const FirstBoxes::Zone* zone_ = nullptr;  // null: all of the domain
};

template <typename... Slab>
GridBoard board_of(SampleGrid& grid, const Slab&... slab) {
    return GridBoard(grid, slab...);
}
template <typename... Slab>
ListBoard board_of(NeighbourLists& lists, const Slab&... slab) {
    return ListBoard(lists, slab...);
}

}  // namespace

template <typename Index>
void screen(Index& index, RoundMemory& round, std::uint32_t column) {
    const std::span<const Candidate> candidates = round.candidates_of(column);
    const auto board = board_of(index);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        board.fetch(candidates[std::min(k + kAhead, candidates.size() - 1)]);
        std::uint32_t& status = round.statuses[round.column_begins[column] + k];
        if (status == STATUS_UNDECIDED && board.is_covered(candidates[k])) status = STATUS_COVERED;
    }
}

template <typename Index>
void Darts::throw_all(Index& index, RoundMemory& round, Workers& workers) {
    const std::uint32_t count = round.count();
    const std::uint32_t most = decltype(board_of(index))::most_slabs(index, round);
    const std::uint32_t slabs = count < kDrawsWorthSlabs ? 1 : most;
    for (std::uint32_t end, begin = 0; begin < count; begin = end) {
        end = begin + std::min(kTurnsAtOnce * slabs, count - begin);
        this->begin(begin, end, slabs);
        workers.for_columns(slabs, end - begin,
                            [&](std::uint32_t slab) { throw_in(index, round, slab); });
        finish(index, round, [&] { workers.poll(); });
    }
}

void Darts::begin(std::uint32_t begin, std::uint32_t end, std::uint32_t slabs) {
    begin_ = begin;
    end_ = end;
    put_off_.resize(slabs);
    for (std::vector<std::uint32_t>& of_slab : put_off_) of_slab.clear();
}

// Lists the slab's candidates in the order of their turns, then entries that are only prefetched.
void Darts::list_turns(const RoundMemory& round, Scratch& scratch) const {
    auto& [thrown, candidates, starts, unsorted, sorted] = scratch;
    if (slabs() == 1) {
        thrown.resize(end_ - begin_);
        for (std::uint32_t turn = begin_; turn < end_; ++turn)
            thrown[turn - begin_] = candidate_of_turn(round.by_order, turn);
    } else {
        unsorted.clear();
        for (const Span& run : candidates)
            for (std::uint32_t i = run.begin; i < run.end; ++i) {
                const std::uint32_t turn = turn_of(round.candidates[i], i);
                if (turn - begin_ < end_ - begin_ && round.statuses[i] != STATUS_COVERED)
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

template <typename Index>
void Darts::throw_in(Index& index, RoundMemory& round, std::uint32_t slab) {
    thread_local Scratch of_thread;
    Scratch& scratch = of_thread;  // looked up once, see subtract.cpp
    auto board = board_of(index, round, slab, put_off_.size());
    if (slabs() > 1) board.find_candidates(round, scratch.candidates);
    list_turns(round, scratch);
    const std::vector<std::uint32_t>& thrown = scratch.thrown;
    const bool is_shared = put_off_.size() > 1;
    for (std::size_t k = 0; k + 2 * kAhead < thrown.size(); ++k) {
        __builtin_prefetch(&round.candidates[thrown[k + 2 * kAhead]]);
        board.fetch(round.candidates[thrown[k + kAhead]]);
        board.fetch_sooner(round.candidates[thrown[k + kAhead / 2]]);
        const std::uint32_t i = thrown[k];
        const Candidate& candidate = round.candidates[i];
        std::uint32_t& status = round.statuses[i];
        if (status == STATUS_ADMITTED) board.insert(candidate);
        if (status != STATUS_UNDECIDED) continue;
        const bool is_inner = board.may_settle(candidate);
        if (is_inner && board.is_covered(candidate)) {
            status = STATUS_REJECTED;
        } else if (is_inner && (!is_shared || !board.has_mark_near(candidate))) {
            status = STATUS_ADMITTED;
            board.insert(candidate);
        } else {
            put_off_[slab].push_back(i);
            board.mark(candidate);
        }
    }
}

template <typename Index>
void Darts::finish(Index& index, RoundMemory& round, const std::function<void()>& poll) {
    std::vector<std::uint32_t>& all = put_off_.front();
    for (std::size_t slab = 1; slab < put_off_.size(); ++slab)
        all.insert(all.end(), put_off_[slab].begin(), put_off_[slab].end());
    std::sort(all.begin(), all.end(), [&](std::uint32_t a, std::uint32_t b) {
        return precedes(round.candidates[a], round.candidates[b]);
    });
    auto board = board_of(index);
    const auto later = [&](std::size_t k) {
        return round.candidates[all[std::min(k, all.size() - 1)]];
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k % kPollEvery == 0) poll();
        board.fetch(later(k + kAhead));
        board.fetch_sooner(later(k + kAhead / 2));
        const std::uint32_t i = all[k];
        const bool is_covered = board.is_covered(round.candidates[i]);
        round.statuses[i] = is_covered ? STATUS_REJECTED : STATUS_ADMITTED;
        if (!is_covered) board.insert(round.candidates[i]);
    }
    board.unmark_all(round.candidates, all);
}

template void screen(SampleGrid&, RoundMemory&, std::uint32_t);
template void screen(NeighbourLists&, RoundMemory&, std::uint32_t);
template void Darts::throw_all(SampleGrid&, RoundMemory&, Workers&);
template void Darts::throw_all(NeighbourLists&, RoundMemory&, Workers&);
// For tests.
template void Darts::throw_in(SampleGrid&, RoundMemory&, std::uint32_t);
template void Darts::finish(SampleGrid&, RoundMemory&, const std::function<void()>&);

}  // namespace lacuna::cpu
