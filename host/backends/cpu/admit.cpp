// admit in lines and cells: a candidate becomes a sample unless an earlier sample covers it.
//
// "Earlier" means by draw number, whatever the order of the work. Two small structs below say what
// covers a candidate in each mode, and how far away that may be. Exact is in darts.cpp.
#include <algorithm>
#include <atomic>

#include "backends/columns.h"
#include "backends/cpu/columns_in_reach.h"
#include "backends/cpu/crowd.h"
#include "backends/cpu/lattice.h"
#include "backends/cpu/precedence.h"
#include "backends/cpu/sorted_bins.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/metric.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// A mode defines the point at which candidate i counts, the columns to search and how far to search
// in them, and the squared distance that i must keep from candidate j.
struct OnLines {
    const RoundMemory& round;
    portable::Stretch columns;

    OnLines(const SortedBins& bins, std::uint32_t column)
        : round(bins.round),
          columns(portable::stretch_around(column, 1, round.columns, round.plan.period_x)) {}
    // A candidate counts at its line's x: only the chord on that line matters.
    Sample at(std::uint32_t i) const {
        return {round.plan.centre_of_line(round.candidates[i].home), round.candidates[i].y};
    }
    template <typename Visit>
    bool any_column_near(std::uint32_t, Visit visit) const {
        for (std::uint32_t k = 0; k < columns.count; ++k)
            if (visit(portable::nth_of_stretch(columns, k, round.columns), round.plan.radius))
                return true;
        return false;
    }
    std::uint64_t limit_squared(std::uint32_t, std::uint32_t) const {
        return round.plan.radius_squared;
    }
};

struct OnLattice {
    const Lattice& lattice;

    OnLattice(const Lattice& the_lattice, std::uint32_t) : lattice(the_lattice) {}
    Sample at(std::uint32_t i) const {
        return {lattice.round.candidates[i].x, lattice.round.candidates[i].y};
    }
    template <typename Visit>
    bool any_column_near(std::uint32_t i, Visit visit) const {
        return ColumnsInReach(lattice, lattice.round.candidates[i], lattice.candidate_radii[i],
                              lattice.widest_candidates)
            .any(visit);
    }
    std::uint64_t limit_squared(std::uint32_t i, std::uint32_t j) const {
        return portable::metric_squared(portable::twice_metric_radius(
            lattice.metric(), lattice.candidate_radii[i], lattice.candidate_radii[j]));
    }
};

// The columns of one pass read each other's statuses while they change. That is safe: a status that
// is decided is final, and an undecided one only makes the reader wait.
std::uint32_t read(RoundMemory& round, std::uint32_t i) {
    return std::atomic_ref(round.statuses[i]).load(std::memory_order_relaxed);
}

void decide(RoundMemory& round, std::uint32_t i, std::uint32_t status) {
    std::atomic_ref(round.statuses[i]).store(status, std::memory_order_relaxed);
}

// Calls visit(index) for the column's candidates within `reach` of y until it returns true; true if
// it did.
template <typename Visit>
bool any_within(const SortedBins& bins, std::uint32_t column, std::uint32_t y, std::uint32_t reach,
                Visit visit) {
    const std::uint32_t height = bins.round.plan.height;
    const std::uint32_t end = bins.round.column_begins[column + 1];
    const auto any_in = [&](std::uint32_t window) {
        const std::uint32_t low = portable::window_begin(window, y, reach, height);
        const std::uint32_t high = portable::window_end(window, y, reach, height);
        if (low >= high) return false;
        for (std::uint32_t i = bins.first_from(column, low);
             i < end && bins.round.candidates[i].y < high; ++i)
            if (visit(i)) return true;
        return false;
    };
    if (any_in(0)) return true;
    if (bins.round.plan.period_y == 0 || (y >= reach && y + reach <= height)) return false;
    return any_in(1) || any_in(2);
}

// The status of candidate i, as far as it follows from the statuses near it.
template <typename Mode>
std::uint32_t status_of(SortedBins& bins, const Mode& mode, std::uint32_t i) {
    RoundMemory& round = bins.round;
    const Plan& plan = round.plan;
    const Sample at = mode.at(i);
    bool waits = false;
    const auto covers = [&](std::uint32_t j) {
        const Candidate& other = round.candidates[j];
        if (!precedes(other, round.candidates[i]) ||
            !portable::are_closer(other.x, other.y, at.x, at.y, plan.period_x, plan.period_y,
                                  mode.limit_squared(i, j)))
            return false;
        const std::uint32_t status = read(round, j);
        waits = waits || status == STATUS_UNDECIDED;
        return status == STATUS_ADMITTED;
    };
    if (mode.any_column_near(i, [&](std::uint32_t column, std::uint32_t reach) {
            return any_within(bins, column, at.y, reach, covers);
        }))
        return STATUS_REJECTED;
    return waits ? STATUS_UNDECIDED : STATUS_ADMITTED;
}

// About how many others candidate i is compared with: the candidates in the buckets that it looks
// into.
template <typename Mode>
std::uint64_t rivals_of(const SortedBins& bins, const Mode& mode, std::uint32_t i) {
    const std::uint32_t height = bins.round.plan.height;
    const std::uint32_t y = bins.round.candidates[i].y;
    const std::uint32_t windows = bins.round.plan.period_y == 0 ? 1 : 3;
    std::uint64_t rivals = 0;
    mode.any_column_near(i, [&](std::uint32_t column, std::uint32_t reach) {
        ++rivals;  // looking at a column costs about one comparison
        for (std::uint32_t window = 0; window < windows; ++window)
            rivals += bins.count_between(column, portable::window_begin(window, y, reach, height),
                                         portable::window_end(window, y, reach, height));
        return false;
    });
    return rivals;
}

// One candidate in kSampled is counted, to estimate the comparisons of all.
constexpr std::uint32_t kSampled = 128;

// The number of draws that are admitted first: all, unless the round crowds (crowd.h). Then each of
// them has few others within its reach.
template <typename Mode, typename ModeBins>
std::uint32_t first_part(const ModeBins& bins) {
    const RoundMemory& round = bins.round;
    const std::uint32_t count = round.count();
    if (count <= kFewDraws) return count;
    std::uint64_t sampled = 0;
    std::uint64_t rivals = 0;
    for (std::uint32_t column = 0; column < round.columns; ++column) {
        const Mode mode(bins, column);
        for (; sampled * kSampled < round.column_begins[column + 1]; ++sampled) {
            const auto i = static_cast<std::uint32_t>(sampled * kSampled);
            if (round.statuses[i] == STATUS_UNDECIDED) rivals += rivals_of(bins, mode, i);
        }
    }
    if (rivals <= kMostRivals * sampled) return count;
    const std::uint64_t few = std::uint64_t{count} * kMostRivals * sampled / rivals;
    return static_cast<std::uint32_t>(std::max<std::uint64_t>(few, kMostRivals));
}

// Decides the column's undecided candidates where possible; true when all are decided.
template <typename Mode>
bool decide_column(SortedBins& bins, const Mode& mode, std::uint32_t column) {
    RoundMemory& round = bins.round;
    bool are_decided = true;
    for (std::uint32_t i = round.column_begins[column]; i < round.column_begins[column + 1]; ++i) {
        if (read(round, i) != STATUS_UNDECIDED) continue;
        const std::uint32_t status = status_of(bins, mode, i);
        if (status == STATUS_UNDECIDED)
            are_decided = false;
        else
            decide(round, i, status);
    }
    return are_decided;
}

// A few passes decide all: the earliest undecided candidate waits for no other.
template <typename Mode, typename ModeBins>
void decide_all(ModeBins& bins, Workers& workers) {
    while (!workers.all_columns(bins.round.columns, bins.round.count(), [&](std::uint32_t column) {
        return decide_column(bins, Mode(bins, column), column);
    })) {
    }
}

// Admits all draws at once or, if they crowd, part by part, and cuts the samples of each part.
template <typename Mode, typename ModeBins>
bool admit_by_passes(ModeBins& bins, Workers& workers) {
    const std::uint32_t count = bins.round.count();
    std::uint32_t end = first_part<Mode>(bins);
    if (end == count) {
        decide_all<Mode>(bins, workers);
        return false;
    }
    Crowd crowd(bins, workers);
    for (std::uint32_t begin = 0; begin < count; begin = end, end += std::min(end, count - end)) {
        crowd.open_part(begin, end);
        decide_all<Mode>(bins, workers);
        crowd.close_part();
        bins.subtract();
    }
    crowd.give_back();
    return true;
}

}  // namespace

bool admit_on_lines(SortedBins& bins, Workers& workers) {
    return admit_by_passes<OnLines>(bins, workers);
}

bool Lattice::admit() {
    return admit_by_passes<OnLattice>(*this, workers_);
}

}  // namespace lacuna::cpu
