// Running sums, the guide table, and draws from them.
#include "marginal.h"

#include <algorithm>
#include <bit>

#include "random.h"

namespace lacuna {
namespace {

// Below so many draws from one cdf, a binary search each is cheaper than a guide.
constexpr std::uint64_t kGuidedRound = 64;

unsigned guide_bits(const Plan& plan) {
    const bool small = plan.round_size != 0 && plan.round_size < kGuidedRound;
    return small ? 0 : static_cast<unsigned>(std::bit_width(plan.lines));
}

}  // namespace

Marginal::Marginal(const Plan& plan)
    : plan_(plan),
      sums_(plan.lines + std::size_t{1}),
      guide_bits_(guide_bits(plan)),
      starts_(plan.lines + std::size_t{1}) {
    guide_.resize(std::size_t{1} << guide_bits_);
}

void Marginal::rebuild(std::span<const std::uint32_t> free_lengths) {
    std::uint64_t sum = 0;
    for (std::size_t line = 0; line < free_lengths.size(); ++line) {
        const std::uint32_t length = free_lengths[line];
        sum += plan_.uniform_x ? (length > 0 ? 1 : 0) : length;
        sums_[line + 1] = sum;
    }
    if (plan_.uniform_x) lengths_.assign(free_lengths.begin(), free_lengths.end());
    if (sum == 0 || guide_bits_ == 0) return;

    // Part j of the guide begins at the weight that random bits j 00...0 scale to.
    std::uint32_t line = 0;
    for (std::size_t j = 0; j < guide_.size(); ++j) {
        const std::uint64_t part_begin = scaled(std::uint64_t{j} << (64 - guide_bits_), sum);
        while (sums_[line + 1] <= part_begin) ++line;
        guide_[j] = line;
    }
}

std::uint32_t Marginal::line_at(std::uint64_t bits, std::uint64_t c) const {
    if (guide_bits_ == 0) {
        const auto above = std::upper_bound(sums_.begin() + 1, sums_.end(), c);
        return static_cast<std::uint32_t>(above - sums_.begin() - 1);
    }
    std::uint32_t line = guide_[bits >> (64 - guide_bits_)];
    while (sums_[line + 1] <= c) ++line;
    return line;
}

// The same numbers as the reference's draw_candidate, up to the walk along the line.
Draw Marginal::draw(std::uint64_t number) const {
    const RandomBits random = random_bits(plan_.seed, number);
    const std::uint64_t c = scaled(random.first, total());
    const std::uint32_t line = line_at(random.first, c);
    std::uint64_t rank = c - sums_[line];
    std::uint64_t offset_bits = random.second;
    if (plan_.uniform_x) {
        rank = scaled(random.second, lengths_[line]);
        offset_bits = random_bits(plan_.seed, number, 1).first;
    }
    const std::uint64_t offset =
        plan_.snap ? plan_.strip_width / 2 : scaled(offset_bits, plan_.strip_width);
    const std::uint64_t x = std::uint64_t{line} * plan_.strip_width + offset;
    return {line, static_cast<std::uint32_t>(rank), static_cast<std::uint32_t>(x), 0};
}

std::span<const Draw> Marginal::invert(std::uint64_t first_number, std::uint32_t count) {
    draws_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        draws_[i] = draw(first_number + i);
        draws_[i].order = i;
    }
    sort_by_line();
    return sorted_;
}

void Marginal::sort_by_line() {
    if (draws_.size() == 1) {
        sorted_ = draws_;
        return;
    }
    std::fill(starts_.begin(), starts_.end(), 0);
    for (const Draw& draw : draws_) ++starts_[draw.line + 1];
    for (std::size_t line = 1; line < starts_.size(); ++line) starts_[line] += starts_[line - 1];
    sorted_.resize(draws_.size());
    for (const Draw& draw : draws_) sorted_[starts_[draw.line]++] = draw;
}

}  // namespace lacuna
