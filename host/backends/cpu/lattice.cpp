// Memory of mode cells. Its bits are cleared in subtract_cells.cpp.
#include "backends/cpu/lattice.h"

#include <algorithm>
#include <bit>

#include "backends/cpu/columns_in_reach.h"
#include "plan/first_free.h"
#include "portable/bits.h"
#include "portable/metric.h"

namespace lacuna::cpu {
namespace {

struct WordsOfLine {
    const Lattice& lattice;
    const std::uint64_t* first_of(std::uint32_t line) const { return lattice.line(line).data(); }
    std::uint32_t length(const std::uint64_t* word) const {
        return static_cast<std::uint32_t>(std::popcount(*word));
    }
    std::uint32_t y_at(std::uint32_t line, const std::uint64_t* word, std::uint32_t rank) const {
        const auto y = static_cast<std::uint32_t>(word - first_of(line)) * 64;
        const auto low = static_cast<std::uint32_t>(*word);
        const std::uint32_t below = portable::count_bits(low);
        if (rank < below) return y + portable::bit_of_rank(low, rank);
        return y + 32 +
               portable::bit_of_rank(static_cast<std::uint32_t>(*word >> 32), rank - below);
    }
};

}  // namespace

Lattice::Lattice(const Plan& plan, Workers& workers)
    : SortedBins(plan, workers),
      radii(*plan.cells().radii),
      words_(words_per_line(plan) / 2),
      bits_(std::make_unique_for_overwrite<std::uint64_t[]>(plan.lines * words_)),
      widest_(plan.lines),
      near_begins_(round.columns + std::size_t{1}) {
    widest_candidates.of_columns.resize(round.columns);
    // With min the radii of free points are not tracked: a limit that none of them exceeds.
    widest_open_.of_columns.resize(round.columns,
                                   plan.cells().metric == Metric::min ? ~std::uint32_t{0} : 0);
    widest_open_.find_blocks();
}

void Lattice::set_free() {
    for_columns(round.plan.lines, [&](std::uint32_t column) { set_column_free(column); });
}

void Lattice::set_column_free(std::uint32_t column) {
    const std::uint32_t begin = begins[column];
    const std::uint32_t end = begins[column + 1];
    const std::vector<std::uint32_t> bits = first_bits(round.plan, begin, end);
    for (std::uint32_t i = begin; i < end; ++i)
        set_bits(i, std::span(bits).subspan(2 * words_ * (i - begin), 2 * words_));
}

void Lattice::set_bits(std::uint32_t index, std::span<const std::uint32_t> of_line) {
    for (std::size_t i = 0; i < words_; ++i)
        line(index)[i] = std::uint64_t{of_line[2 * i + 1]} << 32 | of_line[2 * i];
}

void Lattice::locate(std::span<const Draw> draws) {
    locate_columns(
        [&](std::uint32_t column) { round.locate_on_lines(draws, column, WordsOfLine{*this}); });
}

void Lattice::make_room(std::size_t count) {
    SortedBins::make_room(count);
    candidate_radii.resize(count);
}

void Lattice::set_undecided(std::uint32_t column) {
    SortedBins::set_undecided(column);
    find_radii(column);
}

void Lattice::find_radii(std::uint32_t column) {
    std::uint32_t widest_radius = 0;
    const std::uint32_t end = round.column_begins[column + 1];
    for (std::uint32_t i = round.column_begins[column]; i < end; ++i) {
        const Candidate& candidate = round.candidates[i];
        candidate_radii[i] = radii.radii[radii.pixel_at(candidate.x, candidate.y)];
        widest_radius = std::max(widest_radius, candidate_radii[i]);
    }
    widest_candidates.of_columns[column] = widest_radius;
}

void WidestRadii::find_blocks() {
    of_blocks.assign(of_columns.size() / kBlock + 1, 0);
    for (std::size_t column = 0; column < of_columns.size(); ++column)
        of_blocks[column / kBlock] = std::max(of_blocks[column / kBlock], of_columns[column]);
}

void Lattice::find_widest_open() {
    if (round.plan.cells().metric == Metric::min) return;
    for (std::uint32_t column = 0; column < round.columns; ++column) {
        std::uint32_t widest_radius = 0;
        for (std::uint32_t x = begins[column]; x < begins[column + 1]; ++x) {
            if (widest_[x] == radii.rows) continue;
            const std::size_t pixels = std::size_t{radii.column_of[x]} * radii.rows;
            widest_radius = std::max(
                widest_radius, portable::class_bound(
                                   radii.radii[pixels + radii.widest_rows[pixels + widest_[x]]]));
        }
        widest_open_.of_columns[column] = widest_radius;
    }
    widest_open_.find_blocks();
}

void Lattice::find_near() {
    // Counts the candidates of each column first, then lists them.
    find_widest_open();
    const auto for_each_near = [&](auto visit) {
        for (std::uint32_t i = 0; i < round.count(); ++i) {
            if (i % 1024 == 0) workers_.poll();
            if (round.statuses[i] != STATUS_ADMITTED) continue;
            ColumnsInReach(*this, round.candidates[i], candidate_radii[i], widest_open_)
                .any([&](std::uint32_t column, std::uint32_t) { return visit(column, i), false; });
        }
    };
    std::fill(near_begins_.begin(), near_begins_.end(), 0);
    for_each_near([&](std::uint32_t column, std::uint32_t) { ++near_begins_[column]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : near_begins_) begin = sum += begin;
    near_.resize(sum);
    for_each_near(
        [&](std::uint32_t column, std::uint32_t i) { near_[--near_begins_[column]] = i; });
}

Snapshot Lattice::snapshot(std::span<const Sample> left_out) const {
    Snapshot snapshot = Bins::snapshot(left_out);
    for (std::size_t i = 0; i < round.plan.lines * words_; ++i) {
        snapshot.bits.push_back(static_cast<std::uint32_t>(bits_[i]));
        snapshot.bits.push_back(static_cast<std::uint32_t>(bits_[i] >> 32));
    }
    return snapshot;
}

void Lattice::restore(const Snapshot& snapshot) {
    SortedBins::restore(snapshot);
    const std::span<const std::uint32_t> all = snapshot.bits;
    for (std::uint32_t i = 0; i < round.plan.lines; ++i) {
        set_bits(i, all.subspan(2 * words_ * i, 2 * words_));
        free_lengths[i] = 0;
        for (const std::uint64_t word : line(i))
            free_lengths[i] += static_cast<std::uint32_t>(std::popcount(word));
    }
    std::fill(widest_.begin(), widest_.end(), 0);
    for (std::uint32_t column = 0; column < round.columns; ++column) find_radii(column);
    end_locate();
}

std::unique_ptr<Bins> make_lattice(const Plan& plan, Workers& workers) {
    return std::make_unique<Lattice>(plan, workers);
}

}  // namespace lacuna::cpu
