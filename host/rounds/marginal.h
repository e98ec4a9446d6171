// The marginal F_X (section 3, Eq. 1) as running sums of the places' free lengths, and its
// inversion (Eq. 2): draws are sorted first, so that one walk along the sums inverts them all.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"
#include "workers.h"

namespace lacuna {

class Marginal {
public:
    // The workers share out all but the running sums. `poll` is called now and then while these are
    // made, and may throw to end that.
    Marginal(const Plan& plan, Workers& workers, std::function<void()> poll)
        : plan_(plan), workers_(workers), poll_(std::move(poll)) {}

    // New running sums, from the free length of every place, all of one width, unless place_widths
    // tells that of each. The lengths and widths are read again by invert: they must stay until
    // then.
    void rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t place_width,
                 std::span<const std::uint32_t> place_widths = {});

    // Total weight of the places: their free length, or their area where widths differ, or, with
    // uniform-x, how many have any.
    std::uint64_t total() const { return sums_.back(); }

    // Draws first_number, first_number + 1, ... of the plan's seed, `count` of them, inverted from
    // one cdf and sorted by place and rank. Valid until the next call. total() must not be 0.
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count);

private:
    class Walk;

    std::uint64_t weight_of(std::size_t place) const;
    Draw drawn(std::uint64_t first_number, std::uint32_t order) const;
    void draw_bits(std::uint64_t first_number, std::uint32_t count);
    void find_ends(std::size_t chunks);
    void invert_part(std::uint64_t first_number, std::span<Draw> part) const;

    const Plan& plan_;
    Workers& workers_;
    std::function<void()> poll_;
    std::span<const std::uint32_t> lengths_;
    std::uint32_t place_width_ = 0;
    std::span<const std::uint32_t> widths_;
    std::vector<std::uint64_t> sums_ = {0};  // sums_[block]: all blocks of places below it
    // A draw's place and rank hold its random bits until it is inverted.
    std::vector<Draw> drawn_;               // by number
    std::vector<Draw> draws_;               // by part: by the highest bits
    unsigned part_bits_ = 0;                // how many those are
    std::vector<std::uint32_t> part_ends_;  // in draws_
    // Of each chunk of numbers, for each part: how many draws, then where in draws_ the next goes.
    std::vector<std::uint32_t> chunk_ends_;
};

}  // namespace lacuna
