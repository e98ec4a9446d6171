// The marginal F_X (section 3, Eq. 1) as running sums of the places' free lengths, and its
// inversion (Eq. 2), in constant time a draw by a guide table (Chen & Asau 1974). Sequential.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "backend.h"
#include "plan.h"
#include "random.h"

namespace lacuna {

class Marginal {
public:
    // `poll` is called now and then during long calls, and may throw to end them.
    Marginal(const Plan& plan, std::function<void()> poll) : plan_(plan), poll_(std::move(poll)) {}

    // New running sums, from the free length of every place, all of one width. The lengths are
    // read again by invert: they must stay until then.
    void rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t place_width);

    // Total weight of the places: their free length or, with uniform-x, how many have any.
    std::uint64_t total() const { return sums_.back(); }

    // Draws first_number, first_number + 1, ... of the plan's seed, `count` of them, inverted from
    // one cdf and sorted by place and rank. Valid until the next call. total() must not be 0.
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count);

private:
    std::size_t block_at(std::uint64_t bits, std::uint64_t c) const;
    Draw draw(const RandomBits& random) const;
    Draw draw_uniform_x(std::uint64_t number, const RandomBits& random) const;
    void sort_parts();

    const Plan& plan_;
    std::function<void()> poll_;
    std::span<const std::uint32_t> lengths_;
    std::uint32_t place_width_ = 0;
    std::vector<std::uint64_t> sums_ = {0};  // sums_[block]: all blocks of places below it
    std::vector<std::uint32_t> guide_;       // guide_[j]: the block at the start of the j-th part
    unsigned guide_bits_ = 0;                // 0: rounds too small to pay for a guide
    std::vector<RandomBits> random_;         // of each draw, by number
    std::vector<std::uint32_t> starts_;      // of each part of the random bits in draws_
    std::vector<Draw> draws_;
};

}  // namespace lacuna
