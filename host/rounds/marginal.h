// The marginal F_X (section 3, Eq. 1) as running sums of the places' free lengths, and its
// inversion (Eq. 2): draws are sorted first, so that one walk along the sums inverts them all.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "base/workers.h"
#include "plan/plan.h"
#include "rounds/random.h"

namespace lacuna {

// Of several marginals that share one cdf, which places are this one's: their weights follow
// `before` others, in `total`.
struct CdfShare {
    std::uint64_t before;
    std::uint64_t total;
};

class Marginal {
public:
    // The workers share out all but the running sums. `poll` is called now and then while these are
    // made, and may throw to end that.
    Marginal(const Plan& plan, Workers& workers, std::function<void()> poll)
        : plan_(plan), workers_(workers), poll_(std::move(poll)) {}

    // New running sums, from the free length of every place, all of one width, unless bin_widths
    // tells that of each. The lengths and widths are read again by invert: they must stay until
    // then.
    void rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t bin_width,
                 std::span<const std::uint32_t> bin_widths = {});

    // Total weight of the places: their free length, or their area where widths differ, or, with
    // uniform-x, how many have any.
    std::uint64_t total() const { return sums_.back(); }

    // Draws first_number, first_number + 1, ... of the plan's seed, `count` of them, inverted from
    // one cdf and sorted by place and rank. Valid until the next call. total() must not be 0.
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count);
    // Of the same draws those that fall into the share, if any. Their orders are 0, 1, ...
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count, CdfShare share);
    // Which of the `count` draws the one of so high an order is.
    std::uint32_t number_of(std::uint32_t order) const;

private:
    class Walk;
    // Random bits that fall into the share: those from first to last. A draw has their distance
    // from the first, shifted left as far as the last allows.
    struct Bits {
        std::uint64_t first = 0;
        std::uint64_t last = 0;
        unsigned shift = 0;
    };
    std::uint64_t weight_of(std::size_t place) const;
    void find_bits(CdfShare share);
    Draw drawn(const RandomBits& random, std::uint64_t first_number, std::uint32_t number) const;
    template <typename Visit>
    void for_each_drawn(std::uint64_t first_number, Span numbers, Visit visit) const;
    void draw_bits(std::uint64_t first_number, std::uint32_t count);
    void find_ends(std::size_t chunks);
    void invert_part(std::uint64_t first_number, std::span<Draw> part) const;

    const Plan& plan_;
    Workers& workers_;
    std::function<void()> poll_;
    std::span<const std::uint32_t> lengths_;
    std::uint32_t bin_width_ = 0;
    std::span<const std::uint32_t> widths_;
    std::vector<std::uint64_t> sums_ = {0};  // sums_[block]: all blocks of places below it
    CdfShare share_{};
    Bits bits_;
    // A draw's place and rank hold its random bits until it is inverted.
    std::vector<Draw> draws_;               // by part: by the highest bits
    std::vector<std::uint32_t> numbers_;    // by order; none where all draws are in the share
    unsigned part_bits_ = 0;                // how many those are
    std::vector<std::uint32_t> part_ends_;  // in draws_
    // Of each chunk of numbers, for each part: how many draws, then where in draws_ the next goes.
    std::vector<std::uint32_t> chunk_ends_;
};

}  // namespace lacuna
