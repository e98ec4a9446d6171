// Candidates of one round that may decide each other's statuses, on both sides of a strip's
// borders.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plan/plan.h"

namespace lacuna {

// A candidate that no sample of an earlier round covers.
struct Rival {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t number;  // of its draw in the round: lower numbers take precedence
    bool is_own;           // or a neighbour's, who tells its status
    std::uint32_t status;  // portable/status.h: undecided, admitted or rejected
};

class Rivals {
public:
    explicit Rivals(const Plan& plan) : plan_(plan) {}

    void clear();
    std::uint32_t add(const Rival& rival);
    Rival& operator[](std::uint32_t index) { return all_[index]; }
    const Rival& operator[](std::uint32_t index) const { return all_[index]; }
    std::size_t size() const { return all_.size(); }

    // Finds what the statuses of these depend on, and so on: earlier own candidates within a
    // radius, up to those of the neighbours. False where that reaches into the stretch of x from
    // which no own candidates were added.
    bool find(std::span<const std::uint32_t> wanted, Span unseen);
    // Decides all own ones found whose statuses follow from those decided so far.
    void decide();

private:
    struct Found {
        std::uint32_t index;
        std::uint32_t first_rival;  // in earlier_; they end where the next one's begin
    };
    void sort_into_cells();
    // Visits all candidates that conflict with this one.
    template <typename Visit>
    void for_each_near(std::uint32_t index, Visit visit) const;
    std::uint64_t cell_of(std::uint32_t column, std::uint32_t y) const;
    std::span<const std::uint32_t> earlier_of(std::size_t found) const;

    const Plan& plan_;
    std::vector<Rival> all_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;  // and indices, sorted
    std::vector<char> is_found_;
    std::vector<Found> found_;
    std::vector<std::uint32_t> earlier_;
    std::vector<std::uint32_t> by_number_;  // of found_
};

}  // namespace lacuna
