// The bins of mode cells: lines of the lattice, with a bit for each point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/cpu/sorted_bins.h"
#include "plan/plan.h"

namespace lacuna::cpu {

// The largest radius in each column, and in each block of kBlock columns. A candidate with a long
// reach skips the columns where all radii are small.
struct WidestRadii {
    static constexpr std::uint32_t kBlock = 64;

    std::vector<std::uint32_t> of_columns;
    std::vector<std::uint32_t> of_blocks;

    // Computes of_blocks from of_columns.
    void find_blocks();
};

class Lattice : public SortedBins {
public:
    Lattice(const Plan& plan, Workers& workers);

    void set_free() override;
    void locate(std::span<const Draw> draws) override;
    bool admit() override;
    void subtract() override;
    Snapshot snapshot(std::span<const Sample> left_out) const override;
    void restore(const Snapshot& snapshot) override;

    void make_room(std::size_t count) override;
    void set_undecided(std::uint32_t column) override;
    void end_locate() override { widest_candidates.find_blocks(); }
    bool is_covered(const Candidate& candidate) const override {
        return (line(candidate.x)[candidate.y / 64] >> candidate.y % 64 & 1) == 0;
    }

    // Bit y of a line is set while its lattice point is free.
    std::span<std::uint64_t> line(std::uint32_t index) const {
        return {&bits_[index * words_], words_};
    }
    // The greatest distance of a conflict with the candidate, in lattice steps.
    std::uint32_t reach_of(const Candidate& candidate) const {
        return radii.reaches[radii.pixel_at(candidate.x, candidate.y)];
    }
    std::uint32_t metric() const { return static_cast<std::uint32_t>(round.plan.cells().metric); }

    const RadiusMap& radii;
    // The radius of each candidate, and the largest ones.
    std::vector<std::uint32_t> candidate_radii;
    WidestRadii widest_candidates;

private:
    void set_column_free(std::uint32_t column);
    // Sets the line's bits from words of 32 bits.
    void set_bits(std::uint32_t index, std::span<const std::uint32_t> of_line);
    void find_radii(std::uint32_t column);
    // Computes widest_open_ from widest_.
    void find_widest_open();
    // Lists the samples that may reach each column.
    void find_near();
    // Blocks the column's points that fail the metric with a sample of the round.
    void subtract(std::uint32_t column);

    std::size_t words_;  // of each line
    std::unique_ptr<std::uint64_t[]> bits_;
    // With mean and max, for each line: the index in RadiusMap::widest_rows of the first row, in
    // the line's column of pixels, that may still have a free point. It goes up as points are
    // blocked.
    std::vector<std::uint32_t> widest_;
    WidestRadii widest_open_;  // radii of points that may still be free
    // Indices of the admitted candidates that may reach column c: near_[near_begins_[c]] up to
    // near_[near_begins_[c + 1]].
    std::vector<std::uint32_t> near_begins_;
    std::vector<std::uint32_t> near_;
};

}  // namespace lacuna::cpu
