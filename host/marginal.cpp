// Running sums, the guide table, and draws from them.
#include "marginal.h"

#include <algorithm>
#include <bit>

#include "random.h"

namespace lacuna {
namespace {

// One running sum for so many places: a cache line of lengths is as fast to walk as to skip.
constexpr std::size_t kBlock = 16;

// Below so many draws from one cdf, a binary search each is cheaper than a guide.
constexpr std::uint64_t kGuidedRound = 64;

// So many draws, or sums, take about a millisecond.
constexpr std::size_t kPollEvery = std::size_t{1} << 14;

// In the order of the cdf.
bool comes_before(const Draw& a, const Draw& b) {
    return a.place != b.place ? a.place < b.place : a.rank < b.rank;
}

}  // namespace

void Marginal::rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t place_width) {
    lengths_ = free_lengths;
    place_width_ = place_width;
    const std::size_t blocks = (lengths_.size() + kBlock - 1) / kBlock;
    sums_.resize(blocks + 1);
    std::uint64_t sum = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        if (block % kPollEvery == 0) poll_();
        const std::size_t end = std::min(lengths_.size(), (block + 1) * kBlock);
        for (std::size_t place = block * kBlock; place < end; ++place)
            sum += plan_.uniform_x ? std::min(lengths_[place], 1u) : lengths_[place];
        sums_[block + 1] = sum;
    }

    const bool small = plan_.round_size != 0 && plan_.round_size < kGuidedRound;
    guide_bits_ = small || sum == 0 ? 0 : static_cast<unsigned>(std::bit_width(blocks));
    if (guide_bits_ == 0) return;
    // Part j of the guide begins at the weight that random bits j 00...0 scale to.
    guide_.resize(std::size_t{1} << guide_bits_);
    std::size_t block = 0;
    for (std::size_t j = 0; j < guide_.size(); ++j) {
        if (j % kPollEvery == 0) poll_();
        const std::uint64_t part_begin = scaled(std::uint64_t{j} << (64 - guide_bits_), sum);
        while (sums_[block + 1] <= part_begin) ++block;
        guide_[j] = static_cast<std::uint32_t>(block);
    }
}

std::size_t Marginal::block_at(std::uint64_t bits, std::uint64_t c) const {
    if (guide_bits_ == 0) {
        const auto above = std::upper_bound(sums_.begin() + 1, sums_.end(), c);
        return static_cast<std::size_t>(above - sums_.begin() - 1);
    }
    std::size_t block = guide_[bits >> (64 - guide_bits_)];
    while (sums_[block + 1] <= c) ++block;
    return block;
}

// The same numbers as the reference's draws, up to the walk along the place's free length.
Draw Marginal::draw(const RandomBits& random) const {
    const std::uint64_t c = scaled(random.first, total());
    const std::size_t block = block_at(random.first, c);
    std::size_t place = block * kBlock;
    std::uint64_t rank = c - sums_[block];
    for (; rank >= lengths_[place]; ++place) rank -= lengths_[place];
    const std::uint64_t offset =
        plan_.snap ? plan_.strip_width / 2 : scaled(random.second, place_width_);
    return {static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(rank),
            static_cast<std::uint32_t>(offset), 0};
}

Draw Marginal::draw_uniform_x(std::uint64_t number, const RandomBits& random) const {
    const std::uint64_t c = scaled(random.first, total());
    const std::size_t block = block_at(random.first, c);
    std::size_t place = block * kBlock;
    for (std::uint64_t before = sums_[block];; ++place) {
        if (lengths_[place] == 0) continue;
        if (before++ == c) break;
    }
    const std::uint64_t bits = random_bits(plan_.seed, number, 1).first;
    const std::uint64_t offset = plan_.snap ? plan_.strip_width / 2 : scaled(bits, place_width_);
    return {static_cast<std::uint32_t>(place),
            static_cast<std::uint32_t>(scaled(random.second, lengths_[place])),
            static_cast<std::uint32_t>(offset), 0};
}

std::span<const Draw> Marginal::invert(std::uint64_t first_number, std::uint32_t count) {
    // The cdf ascends with the random bits: draws sorted by their high bits are almost sorted.
    const unsigned shift = 65 - static_cast<unsigned>(std::bit_width(count + 1));
    random_.resize(count);
    starts_.assign((std::size_t{1} << (64 - shift)) + 1, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % kPollEvery == 0) poll_();
        random_[i] = random_bits(plan_.seed, first_number + i);
        ++starts_[(random_[i].first >> shift) + 1];
    }
    for (std::size_t part = 1; part < starts_.size(); ++part) starts_[part] += starts_[part - 1];

    draws_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % kPollEvery == 0) poll_();
        Draw& to = draws_[starts_[random_[i].first >> shift]++];
        to = plan_.uniform_x ? draw_uniform_x(first_number + i, random_[i]) : draw(random_[i]);
        to.order = i;
    }
    sort_parts();
    return draws_;
}

void Marginal::sort_parts() {
    for (std::size_t i = 1; i < draws_.size(); ++i) {
        const Draw moved = draws_[i];
        std::size_t to = i;
        for (; to > 0 && comes_before(moved, draws_[to - 1]); --to) draws_[to] = draws_[to - 1];
        draws_[to] = moved;
    }
}

}  // namespace lacuna
