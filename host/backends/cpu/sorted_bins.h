// Modes lines and cells: the bins are lines, and admit finds candidates near each other by height.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/columns.h"
#include "backends/cpu/bins.h"

namespace lacuna::cpu {

class SortedBins : public Bins {
public:
    SortedBins(const Plan& plan, Workers& workers);

    void restore(const Snapshot& snapshot) override;

    // The candidates of the round become others, `count` of them. Call this, then for each column
    // set_undecided, then end_locate.
    virtual void make_room(std::size_t count);
    // Sorts the column's candidates for admit.
    virtual void set_undecided(std::uint32_t column);
    virtual void end_locate() {}
    // Whether the candidate's point was cut from its bin.
    virtual bool is_covered(const Candidate& candidate) const = 0;

    // Index of the column's first candidate that is not below y, or the column's end.
    std::uint32_t first_from(std::uint32_t column, std::uint32_t y) const;
    // The number of the column's candidates in the buckets of the heights [low, high).
    std::uint32_t count_between(std::uint32_t column, std::uint32_t low, std::uint32_t high) const;

protected:
    // Locates all draws with locate_column(column).
    template <typename LocateColumn>
    void locate_columns(LocateColumn locate_column) {
        make_room(round.candidates.size());
        for_columns(round.candidates.size(), [&](std::uint32_t column) {
            locate_column(column);
            set_undecided(column);
            round.find_orders(column);
        });
        end_locate();
    }
    // Sorts the column's candidates by y, and by order where y is equal.
    void sort_column(std::uint32_t column);

private:
    // A column has as many buckets as candidates (portable/column.h). Bucket b begins at the
    // column's candidate number buckets_[column_begins[column] + b].
    std::vector<std::uint32_t> buckets_;
};

// admit in mode lines.
bool admit_on_lines(SortedBins& bins, Workers& workers);

}  // namespace lacuna::cpu
