// Running sums, sorted random bits, and the walk that makes draws of them.
#include "rounds/marginal.h"

#include <algorithm>
#include <bit>

#include "rounds/random.h"

namespace lacuna {
namespace {

// One running sum for so many places: a cache line of lengths is as fast to walk as to skip.
constexpr std::size_t kBlock = 16;

// About so many draws are sorted at a time: they stay in the cache of a core.
constexpr unsigned kPartBits = 12;

// So many draws, or sums, take about a millisecond.
constexpr std::size_t kPollEvery = std::size_t{1} << 14;

std::uint64_t bits_of(const Draw& draw) {
    return std::uint64_t{draw.place} << 32 | draw.rank;
}

// So many of the bits, after the highest `skipped`.
std::size_t highest(const Draw& draw, unsigned count, unsigned skipped = 0) {
    return bits_of(draw) << skipped >> 32 >> (32 - count);
}

// Counts become the places where what is counted begins.
void sum_before(std::vector<std::uint32_t>& counts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) sum += std::exchange(count, sum);
}

// Fast when almost sorted.
template <typename Before>
void insertion_sort(std::span<Draw> draws, Before comes_before) {
    for (std::size_t i = 1; i < draws.size(); ++i) {
        const Draw moved = draws[i];
        std::size_t to = i;
        for (; to > 0 && comes_before(moved, draws[to - 1]); --to) draws[to] = draws[to - 1];
        draws[to] = moved;
    }
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
}

// Inverts the cdf at weights that ascend.
class Marginal::Walk {
public:
    explicit Walk(const Marginal& marginal) : sums_(marginal.sums_), lengths_(marginal.lengths_) {}

    // The same numbers as the reference's, up to the walk along the place's free length.
    void invert(Draw& draw) {
        const std::uint64_t c = scaled(bits_of(draw), sums_.back());
        seek(c);
        std::size_t place = block_ * kBlock;
        std::uint64_t rank = c - sums_[block_];
        for (; rank >= lengths_[place]; ++place) rank -= lengths_[place];
        draw.place = static_cast<std::uint32_t>(place);
        draw.rank = static_cast<std::uint32_t>(rank);
    }

    void invert_uniform_x(Draw& draw, std::uint64_t for_rank) {
        const std::uint64_t c = scaled(bits_of(draw), sums_.back());
        seek(c);
        std::size_t place = block_ * kBlock;
        for (std::uint64_t before = sums_[block_];; ++place) {
            if (lengths_[place] == 0) continue;
            if (before++ == c) break;
        }
        draw.place = static_cast<std::uint32_t>(place);
        draw.rank = static_cast<std::uint32_t>(scaled(for_rank, lengths_[place]));
    }

private:
    // To the block that weight c falls into. Gallops: the next one is near when draws are many,
    // and far when they are few.
    void seek(std::uint64_t c) {
        if (sums_[block_ + 1] > c) return;
        std::size_t step = 2;
        while (block_ + step < sums_.size() && sums_[block_ + step] <= c) step *= 2;
        const std::uint64_t* const first = sums_.data();
        const std::size_t end = std::min(block_ + step, sums_.size());
        const std::uint64_t* const above =
            std::upper_bound(first + block_ + step / 2, first + end, c);
        block_ = static_cast<std::size_t>(above - first - 1);
    }

    std::span<const std::uint64_t> sums_;
    std::span<const std::uint32_t> lengths_;
    std::size_t block_ = 0;
};

// Leaves the draws of each part together, not inverted.
void Marginal::draw_bits(std::uint64_t first_number, std::uint32_t count) {
    const auto width = static_cast<unsigned>(std::bit_width(count));
    part_bits_ = std::max(width, kPartBits) - kPartBits;
    part_ends_.assign(std::size_t{1} << part_bits_, 0);
    drawn_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % kPollEvery == 0) poll_();
        const RandomBits random = random_bits(plan_.seed, first_number + i);
        const std::uint64_t for_offset =
            plan_.uniform_x ? random_bits(plan_.seed, first_number + i, 1).first : random.second;
        const std::uint64_t offset =
            plan_.snap ? plan_.strip_width / 2 : scaled(for_offset, place_width_);
        drawn_[i] = {static_cast<std::uint32_t>(random.first >> 32),
                     static_cast<std::uint32_t>(random.first), static_cast<std::uint32_t>(offset),
                     i};
        ++part_ends_[highest(drawn_[i], part_bits_)];
    }
    sum_before(part_ends_);
    draws_.resize(count);
    for (const Draw& draw : drawn_) draws_[part_ends_[highest(draw, part_bits_)]++] = draw;
}

// By the next highest bits, then by all.
void Marginal::sort_part(std::span<const Draw> part) {
    const auto bits = static_cast<unsigned>(std::bit_width(part.size()));
    starts_.assign(std::size_t{1} << bits, 0);
    for (const Draw& draw : part) ++starts_[highest(draw, bits, part_bits_)];
    sum_before(starts_);
    part_.resize(part.size());
    for (const Draw& draw : part) part_[starts_[highest(draw, bits, part_bits_)]++] = draw;
    insertion_sort(part_, [](const Draw& a, const Draw& b) { return bits_of(a) < bits_of(b); });
}

std::span<const Draw> Marginal::invert(std::uint64_t first_number, std::uint32_t count) {
    draw_bits(first_number, count);
    Walk walk(*this);
    std::uint32_t begin = 0;
    for (const std::uint32_t end : part_ends_) {
        poll_();
        sort_part(std::span(draws_).subspan(begin, end - begin));
        for (Draw& draw : part_) {
            if (plan_.uniform_x)
                walk.invert_uniform_x(draw,
                                      random_bits(plan_.seed, first_number + draw.order).second);
            else
                walk.invert(draw);
            draws_[begin++] = draw;
        }
    }
    if (plan_.uniform_x)  // whose ranks do not ascend with the bits
        insertion_sort(draws_, [](const Draw& a, const Draw& b) {
            return a.place != b.place ? a.place < b.place : a.rank < b.rank;
        });
    return draws_;
}

}  // namespace lacuna
