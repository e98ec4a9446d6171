// The marginal F_X (section 3, Eq. 1) as running sums of the bins' free lengths or areas, and its
// inversion (Eq. 2). Draws are sorted first, so that one walk along the sums inverts all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "plan/plan.h"
#include "rounds/copy_shares.h"
#include "rounds/random.h"
#include "rounds/round.h"

namespace lacuna {

// The part of a cdf that belongs to one of several marginals. The cdf's weight is `total`, and
// `before` of it precedes this marginal's bins.
struct CdfShare {
    std::uint64_t before;
    std::uint64_t total;
};

class Marginal {
public:
    // The workers do everything in parallel except the running sums. While these are made, `poll`
    // is called now and then; it may throw to end the work. The draws of a round are made where
    // `room` says, see Backend::room_for_draws.
    using Room = std::function<std::span<Draw>(std::size_t)>;
    Marginal(const Plan& plan, Workers& workers, std::function<void()> poll, Room room = {})
        : plan_(plan), workers_(workers), poll_(std::move(poll)), room_(std::move(room)) {}

    // Makes new running sums from the free length of every bin. All bins are `bin_width` wide,
    // unless bin_widths has the width of each. invert() reads lengths and widths again, so they
    // must live until then. With classes, copy_ends has the number of bins up to the end of each
    // copy (plan/class_copies.h).
    void rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t bin_width,
                 std::span<const std::uint32_t> bin_widths = {},
                 std::span<const std::uint32_t> copy_ends = {});

    // Total weight of the bins: the sum of their free lengths, or of their areas if widths differ.
    // With uniform-x it is the number of bins with free length.
    std::uint64_t total() const { return sums_.back(); }

    // Inverts `count` draws of the plan's seed, first_number, first_number + 1, ..., from one cdf.
    // They are sorted by bin and rank, and valid until the next call. total() must not be 0.
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count);
    // The same, but only the draws that fall into the share, if any. Their orders are 0, 1, ...
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count, CdfShare share);
    // The number, from 0 to count - 1, of the draw with this order among the draws in the share.
    std::uint32_t number_of(std::uint32_t order) const;

private:
    class Walk;
    // The random bits that fall into the share are first to last. A draw stores their distance from
    // `first`, shifted left by `shift`, as far as the range allows.
    struct Bits {
        std::uint64_t first = 0;
        std::uint64_t last = 0;
        unsigned shift = 0;
    };
    std::uint64_t weight_of(std::size_t bin) const;
    void find_copy_shares(std::span<const std::uint32_t> copy_ends);
    void find_bits(CdfShare share);
    Draw drawn(const RandomBits& random, std::uint64_t first_number, std::uint32_t number) const;
    template <typename Visit>
    void for_each_drawn(std::uint64_t first_number, Span numbers, Visit visit) const;
    void draw_bits(std::uint64_t first_number, std::uint32_t count);
    void make_room(std::size_t count);
    void find_ends(std::size_t chunks);
    void invert_part(std::uint64_t first_number, std::span<Draw> part) const;

    const Plan& plan_;
    Workers& workers_;
    std::function<void()> poll_;
    Room room_;
    std::vector<Draw> own_room_;  // where room_ has none
    std::span<const std::uint32_t> lengths_;
    std::uint32_t bin_width_ = 0;
    std::span<const std::uint32_t> widths_;
    std::vector<std::uint64_t> sums_ = {0};  // sums_[i]: weight of all bins before block i
    CdfShare share_{};
    std::optional<CopyShares> copy_shares_;  // with classes
    Bits bits_;
    // Until a draw is inverted, its bin and rank hold its random bits.
    std::span<Draw> draws_;                 // grouped by part, the highest bits
    std::vector<std::uint32_t> numbers_;    // by order; empty if all draws are in the share
    unsigned part_bits_ = 0;                // number of bits that select a part
    std::vector<std::uint32_t> part_ends_;  // index in draws_
    // For each chunk and part: the number of draws; later the index in draws_ of the next one.
    std::vector<std::uint32_t> chunk_ends_;
};

}  // namespace lacuna
