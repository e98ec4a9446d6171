// Dart throwing in slabs.
#include "backends/cpu/darts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <type_traits>

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

// A slab of the sample grid is a run of columns. It decides the candidates whose x lies in inner_:
// they read only cells whose x lies in own_, which no other slab changes.
class GridSlab {
public:
    GridSlab(const SampleGrid&, const RoundMemory& round, std::uint32_t number, std::size_t slabs) {
        if (slabs == 1) return;
        const Plan& plan = round.plan;
        const auto column_at = [&](std::size_t border) {
            return static_cast<std::uint32_t>(border * round.columns / slabs);
        };
        const auto x_of = [&](std::uint32_t column) {
            return plan.strip_width *
                   portable::first_line_of_column(column, plan.lines, round.columns);
        };
        columns_ = {column_at(number), column_at(number + std::size_t{1})};
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
    static std::uint32_t most(const SampleGrid&, const RoundMemory& round) {
        return std::clamp(round.columns / 64, 1u, 1024u);
    }

    // The slab's candidates, in runs.
    void find_candidates(const RoundMemory& round, std::vector<Span>& found) const {
        found = {{round.column_begins[columns_.begin], round.column_begins[columns_.end]}};
    }
    bool may_settle(const Candidate& candidate) const { return is_in(inner_, candidate.x); }
    void insert(SampleGrid& grid, const Candidate& sample) const { grid.insert(sample); }
    void mark(SampleGrid& grid, const Candidate& candidate) const {
        if (is_in(own_, candidate.x)) grid.mark(candidate);
    }

private:
    static bool is_in(const Span& stretch, std::uint32_t x) {
        return x >= stretch.begin && x < stretch.end;
    }

    Span columns_{0, 0};
    Span own_{0, ~std::uint32_t{0}};
    Span inner_{0, ~std::uint32_t{0}};
};

// A slab of the neighbour lists is a zone. It decides the candidates whose disk lies in it: no
// conflict is farther away than a candidate's own radius, times the greatest factor of its class.
class ListSlab {
public:
    ListSlab(const NeighbourLists& lists, const RoundMemory&, std::uint32_t number,
             std::size_t slabs)
        : lists_(lists),
          number_(number),
          zone_(slabs == 1 ? nullptr : &lists.first().zones[number]) {}
    static std::uint32_t most(const NeighbourLists& lists, const RoundMemory&) {
        return std::max(1u, static_cast<std::uint32_t>(lists.first().zones.size()));
    }

    void find_candidates(const RoundMemory& round, std::vector<Span>& found) const {
        found.clear();
        for (const std::uint32_t region : zone_->regions)
            found.push_back({round.column_begins[region], round.column_begins[region + 1]});
    }
    bool may_settle(const Candidate& at) const {
        if (zone_ == nullptr) return true;
        const ClassCopies& copies = lists_.plan().field().copies;
        const Box& own = lists_.first().nodes[zone_->nodes.front()].box;
        const std::uint32_t reach = portable::times_factor(lists_.sized(at).radius,
                                                           copies.greatest_factor(copies.of(at.x)));
        const std::uint32_t x = copies.x_on_copy(at.x);
        const std::uint32_t own_x = copies.x_on_copy(own.x);
        return x - own_x >= reach && own_x + own.width - x > reach && at.y - own.begin >= reach &&
               own.end - at.y > reach;
    }
    void insert(NeighbourLists& lists, const Candidate& sample) const {
        // A candidate that the slab could not decide may reach beyond the zone.
        lists.insert(lists.sized(sample), sample.home, may_settle(sample) ? zone_ : nullptr);
    }
    void mark(NeighbourLists& lists, const Candidate& candidate) const {
        lists.mark(lists.sized(candidate), number_);
    }

private:
    const NeighbourLists& lists_;
    std::uint32_t number_;
    const FirstBoxes::Zone* zone_;  // null: all of the domain
};

template <typename Index>
using SlabOf = std::conditional_t<std::is_same_v<Index, SampleGrid>, GridSlab, ListSlab>;

}  // namespace

template <typename Index>
void screen(Index& index, RoundMemory& round, std::uint32_t column) {
    const std::span<const Candidate> candidates = round.candidates_of(column);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        index.fetch(candidates[std::min(k + kAhead, candidates.size() - 1)]);
        std::uint32_t& status = round.statuses[round.column_begins[column] + k];
        if (status == STATUS_UNDECIDED && index.is_covered(candidates[k])) status = STATUS_COVERED;
    }
}

template <typename Index>
void Darts::throw_all(Index& index, RoundMemory& round, Workers& workers) {
    const std::uint32_t count = round.count();
    const std::uint32_t slabs = count < kDrawsWorthSlabs ? 1 : SlabOf<Index>::most(index, round);
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
void Darts::throw_in(Index& index, RoundMemory& round, std::uint32_t number) {
    thread_local Scratch of_thread;
    Scratch& scratch = of_thread;  // looked up once, see subtract.cpp
    const SlabOf<Index> slab(index, round, number, put_off_.size());
    if (slabs() > 1) slab.find_candidates(round, scratch.candidates);
    list_turns(round, scratch);
    const std::vector<std::uint32_t>& thrown = scratch.thrown;
    const bool is_shared = put_off_.size() > 1;
    for (std::size_t k = 0; k + 2 * kAhead < thrown.size(); ++k) {
        __builtin_prefetch(&round.candidates[thrown[k + 2 * kAhead]]);
        index.fetch(round.candidates[thrown[k + kAhead]]);
        index.fetch_sooner(round.candidates[thrown[k + kAhead / 2]]);
        const std::uint32_t i = thrown[k];
        const Candidate& candidate = round.candidates[i];
        std::uint32_t& status = round.statuses[i];
        if (status == STATUS_ADMITTED) slab.insert(index, candidate);
        if (status != STATUS_UNDECIDED) continue;
        const bool is_inner = slab.may_settle(candidate);
        if (is_inner && index.is_covered(candidate)) {
            status = STATUS_REJECTED;
        } else if (is_inner && (!is_shared || !index.has_mark_near(candidate))) {
            status = STATUS_ADMITTED;
            slab.insert(index, candidate);
        } else {
            put_off_[number].push_back(i);
            slab.mark(index, candidate);
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
    const auto later = [&](std::size_t k) {
        return round.candidates[all[std::min(k, all.size() - 1)]];
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k % kPollEvery == 0) poll();
        index.fetch(later(k + kAhead));
        index.fetch_sooner(later(k + kAhead / 2));
        const std::uint32_t i = all[k];
        const bool is_covered = index.is_covered(round.candidates[i]);
        round.statuses[i] = is_covered ? STATUS_REJECTED : STATUS_ADMITTED;
        if (!is_covered) index.insert(round.candidates[i]);
    }
    index.unmark_all(round.candidates, all);
}

template void screen(SampleGrid&, RoundMemory&, std::uint32_t);
template void screen(NeighbourLists&, RoundMemory&, std::uint32_t);
template void Darts::throw_all(SampleGrid&, RoundMemory&, Workers&);
template void Darts::throw_all(NeighbourLists&, RoundMemory&, Workers&);
// For tests.
template void Darts::throw_in(SampleGrid&, RoundMemory&, std::uint32_t);
template void Darts::finish(SampleGrid&, RoundMemory&, const std::function<void()>&);

}  // namespace lacuna::cpu
