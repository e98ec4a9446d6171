// Candidates of one round, on both sides of a strip's borders, that may decide each other's
// statuses.
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
    std::uint32_t number;  // of its draw in the round: lower numbers have precedence
    bool is_own;           // otherwise a neighbour's, which sends its status
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

    // Finds the candidates on which the statuses of `wanted` depend: earlier candidates within a
    // radius, from these in turn, until a neighbour's are met. False if the search reaches the
    // interval `unseen` of x, from which no candidates of this rank were added.
    bool find(std::span<const std::uint32_t> wanted, Span unseen);
    // Decides the found candidates of this rank whose statuses follow from the known ones.
    void decide();

private:
    struct Found {
        std::uint32_t index;
        std::uint32_t first_rival;  // in earlier_; ends where the next one's begin
    };
    void sort_into_cells();
    // Visits all candidates that conflict with this one.
    template <typename Visit>
    void for_each_near(std::uint32_t index, Visit visit) const;
    std::uint64_t cell_of(std::uint32_t column, std::uint32_t y) const;
    std::span<const std::uint32_t> earlier_of(std::size_t found) const;

    const Plan& plan_;
    std::vector<Rival> all_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;  // pairs of cell and index, sorted
    std::vector<char> is_found_;
    std::vector<Found> found_;
    std::vector<std::uint32_t> earlier_;
    std::vector<std::uint32_t> by_number_;  // indices in found_
};

}  // namespace lacuna
