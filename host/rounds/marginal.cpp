// Running sums, random bits in sorted order, and the walk that turns them into draws.
#include "rounds/marginal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

#include "base/insertion_sort.h"
#include "rounds/random_run.h"

namespace lacuna {
namespace {

// Bins for each running sum. Walking along a cache line of lengths is as fast as skipping it.
constexpr std::size_t kBlock = 16;
// About 2^kPartBits draws are sorted at a time, so that they stay in a core's cache.
constexpr unsigned kPartBits = 12;
// Draws go to threads in chunks of at least 2^12, which take 0.1 ms, and in at most kMostChunks,
// because each chunk counts its draws of every part.
constexpr std::uint32_t kLeastChunk = std::uint32_t{1} << 12;
constexpr std::uint32_t kMostChunks = 64;
constexpr std::uint64_t kAllBits = ~std::uint64_t{0};
constexpr std::uint32_t kRun = 256;  // draws whose random bits are made at a time
// Number of sums between two polls: they take about a millisecond.
constexpr std::size_t kPollEvery = std::size_t{1} << 14;

std::uint64_t bits_of(const Draw& draw) {
    return std::uint64_t{draw.bin} << 32 | draw.rank;
}

// `count` of the draw's bits, after the highest `skipped` ones.
std::size_t highest(const Draw& draw, unsigned count, unsigned skipped = 0) {
    return bits_of(draw) << skipped >> 32 >> (32 - count);
}

void sum_before(std::vector<std::uint32_t>& counts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) sum += std::exchange(count, sum);
}

}  // namespace

// Eq. 1. With uniform-x the weight is 1 if the bin has any free length, otherwise 0.
std::uint64_t Marginal::weight_of(std::size_t bin) const {
    if (plan_.is_uniform_x()) return std::min(lengths_[bin], 1u);
    return widths_.empty() ? lengths_[bin] : std::uint64_t{widths_[bin]} * lengths_[bin];
}

void Marginal::rebuild(std::span<const std::uint32_t> free_lengths, std::uint32_t bin_width,
                       std::span<const std::uint32_t> bin_widths,
                       std::span<const std::uint32_t> copy_ends) {
    lengths_ = free_lengths;
    bin_width_ = bin_width;
    widths_ = bin_widths;
    const std::size_t blocks = (lengths_.size() + kBlock - 1) / kBlock;
    sums_.resize(blocks + 1);
    std::uint64_t sum = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        if (block % kPollEvery == 0) poll_();
        const std::size_t end = std::min(lengths_.size(), (block + 1) * kBlock);
        for (std::size_t bin = block * kBlock; bin < end; ++bin) sum += weight_of(bin);
        sums_[block + 1] = sum;
    }
    if (!copy_ends.empty()) find_copy_shares(copy_ends);
}

void Marginal::find_copy_shares(std::span<const std::uint32_t> copy_ends) {
    std::vector<std::uint64_t> areas;
    std::vector<std::uint32_t> weights;
    for (const std::uint32_t end : copy_ends) {
        std::uint64_t area = sums_[end / kBlock];
        for (std::size_t bin = end / kBlock * kBlock; bin < end; ++bin) area += weight_of(bin);
        weights.push_back(plan_.field().copies.weight(static_cast<std::uint32_t>(areas.size())));
        areas.push_back(area);
    }
    copy_shares_.emplace(areas, weights);
}

// Inverts the cdf at ascending weights.
class Marginal::Walk {
public:
    explicit Walk(const Marginal& marginal)
        : sums_(marginal.sums_),
          lengths_(marginal.lengths_),
          widths_(marginal.widths_),
          bits_(marginal.bits_),
          share_(marginal.share_),
          copy_shares_(marginal.copy_shares_ ? &*marginal.copy_shares_ : nullptr) {}

    // Finds bin and rank as the reference does; locate walks along the bin's free spans later.
    void invert(Draw& draw) {
        const std::uint64_t c = weight_of(draw);
        seek(c);
        std::size_t bin = block_ * kBlock;
        std::uint64_t rank = c - sums_[block_];
        for (; rank >= lengths_[bin]; ++bin) rank -= lengths_[bin];
        draw.bin = static_cast<std::uint32_t>(bin);
        draw.rank = static_cast<std::uint32_t>(rank);
    }

    // Weights are areas: the excess of c over the sum before the bin is a point of its area.
    void invert_areas(Draw& draw) {
        const std::uint64_t c = weight_of(draw);
        seek(c);
        std::size_t bin = block_ * kBlock;
        std::uint64_t rank = c - sums_[block_];
        const auto area = [&] { return std::uint64_t{widths_[bin]} * lengths_[bin]; };
        for (; rank >= area(); ++bin) rank -= area();
        draw.bin = static_cast<std::uint32_t>(bin);
        draw.rank = static_cast<std::uint32_t>(rank / widths_[bin]);
        draw.offset = static_cast<std::uint32_t>(rank % widths_[bin]);
    }

    // In space the draw has random bits in place of a rank and an offset, because a weight is no
    // number of positions.
    void invert_in_space(Draw& draw, std::uint64_t for_position) {
        invert_areas(draw);
        draw.rank = static_cast<std::uint32_t>(for_position >> 32U);
        draw.offset = static_cast<std::uint32_t>(for_position);
    }

    void invert_uniform_x(Draw& draw, std::uint64_t for_rank) {
        const std::uint64_t c = weight_of(draw);
        seek(c);
        std::size_t bin = block_ * kBlock;
        for (std::uint64_t before = sums_[block_];; ++bin) {
            if (lengths_[bin] == 0) continue;
            if (before++ == c) break;
        }
        draw.bin = static_cast<std::uint32_t>(bin);
        draw.rank = static_cast<std::uint32_t>(scaled(for_rank, lengths_[bin]));
    }

private:
    // The weight within this CdfShare to which the draw's bits belong.
    std::uint64_t weight_of(const Draw& draw) const {
        if (copy_shares_ != nullptr) return copy_shares_->area_at(bits_of(draw));
        return scaled((bits_of(draw) >> bits_.shift) + bits_.first, share_.total) - share_.before;
    }
    // Goes to the block that contains weight c, with steps that double: it is near if there are
    // many draws, and far if there are few.
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
    std::span<const std::uint32_t> widths_;
    Bits bits_;
    CdfShare share_;
    const CopyShares* copy_shares_;
    std::size_t block_ = 0;
};

// A draw that holds its random bits instead of bin and rank.
Draw Marginal::drawn(const RandomBits& random, std::uint64_t first_number,
                     std::uint32_t number) const {
    const std::uint64_t for_offset = plan_.is_uniform_x()
                                         ? random_bits(plan_.seed, first_number + number, 1).first
                                         : random.second;
    const std::uint64_t offset =
        plan_.snaps() ? plan_.strip_width / 2 : scaled(for_offset, bin_width_);
    const std::uint64_t bits = (random.first - bits_.first) << bits_.shift;
    return {static_cast<std::uint32_t>(bits >> 32), static_cast<std::uint32_t>(bits),
            static_cast<std::uint32_t>(offset), number};
}

// Calls visit(number, random bits) for the draws [begin, end) that fall into the CdfShare.
template <typename Visit>
void Marginal::for_each_drawn(std::uint64_t first_number, Span numbers, Visit visit) const {
    const std::uint64_t width = bits_.last - bits_.first;
    std::array<RandomBits, kRun> run;
    std::array<std::uint32_t, kRun> in_share;
    for (std::uint32_t begin = numbers.begin; begin < numbers.end;) {
        const std::uint32_t size = std::min(kRun, numbers.end - begin);
        random_run(plan_.seed, first_number + begin, std::span(run).first(size));
        // No branch, because nothing predicts which draws fall into the CdfShare.
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i < size && width == kAllBits; ++i) visit(begin + i, run[i]);
        for (std::uint32_t i = 0; i < size && width != kAllBits; ++i) {
            in_share[count] = i;
            count += static_cast<std::uint32_t>(run[i].first - bits_.first <= width);
        }
        for (std::uint32_t i = 0; i < count; ++i) visit(begin + in_share[i], run[in_share[i]]);
        begin += size;
    }
}

// Groups the draws by part, each part in the order of the draws, not yet inverted. Counts the draws
// first; then makes the random bits a second time, which is faster than storing them.
void Marginal::draw_bits(std::uint64_t first_number, std::uint32_t count) {
    const std::uint64_t expected = scaled(bits_.last - bits_.first, count);
    const auto width = static_cast<unsigned>(std::bit_width(expected + 1));
    part_bits_ = std::max(width, kPartBits) - kPartBits;
    const std::size_t parts = std::size_t{1} << part_bits_;
    const std::uint32_t size = std::max(kLeastChunk, count / kMostChunks + 1);
    const std::uint32_t chunks = (count - 1) / size + 1;
    chunk_ends_.assign(chunks * parts, 0);
    std::vector<std::uint32_t> orders(chunks);
    const auto numbers_of = [&](std::uint32_t chunk) {
        const std::uint32_t begin = chunk * size;
        return Span{begin, begin + std::min(size, count - begin)};
    };
    const auto part_of = [&](const RandomBits& random) {
        return (random.first - bits_.first) << bits_.shift >> 32 >> (32 - part_bits_);
    };
    workers_.for_columns(chunks, count, [&](std::uint32_t chunk) {
        const std::span<std::uint32_t> counts =
            std::span(chunk_ends_).subspan(chunk * parts, parts);
        if (parts == 1 && bits_.last - bits_.first == kAllBits) {
            const Span numbers = numbers_of(chunk);
            counts[0] = orders[chunk] = numbers.end - numbers.begin;
            return;
        }
        for_each_drawn(first_number, numbers_of(chunk),
                       [&](std::uint32_t, const RandomBits& random) { ++counts[part_of(random)]; });
        orders[chunk] = std::reduce(counts.begin(), counts.end());
    });
    find_ends(chunks);
    sum_before(orders);
    make_room(part_ends_.back());
    numbers_.resize(part_ends_.back() < count ? part_ends_.back() : 0);
    workers_.for_columns(chunks, count, [&](std::uint32_t chunk) {
        const std::span<std::uint32_t> ends = std::span(chunk_ends_).subspan(chunk * parts, parts);
        std::uint32_t order = orders[chunk];
        for_each_drawn(first_number, numbers_of(chunk),
                       [&](std::uint32_t number, const RandomBits& random) {
                           Draw& draw = draws_[ends[part_of(random)]++];
                           draw = drawn(random, first_number, number);
                           if (numbers_.empty()) return;
                           numbers_[order] = number;
                           draw.order = order++;
                       });
    });
}

void Marginal::make_room(std::size_t count) {
    draws_ = room_ ? room_(count) : std::span<Draw>();
    if (draws_.size() == count) return;
    own_room_.resize(count);
    draws_ = own_room_;
}

void Marginal::find_ends(std::size_t chunks) {
    const std::size_t parts = std::size_t{1} << part_bits_;
    part_ends_.resize(parts);
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            std::uint32_t& entry = chunk_ends_[chunk * parts + part];
            sum += std::exchange(entry, sum);
        }
        part_ends_[part] = sum;
    }
}

// Sorts a part by its next highest bits, then by all bits, and walks along the cdf.
void Marginal::invert_part(std::uint64_t first_number, std::span<Draw> part) const {
    struct Scratch {
        std::vector<Draw> sorted;
        std::vector<std::uint32_t> starts;
    };
    thread_local Scratch of_thread;
    auto& [sorted, starts] = of_thread;
    const auto bits = static_cast<unsigned>(std::bit_width(part.size()));
    starts.assign(std::size_t{1} << bits, 0);
    for (const Draw& draw : part) ++starts[highest(draw, bits, part_bits_)];
    sum_before(starts);
    sorted.resize(part.size());
    for (const Draw& draw : part) sorted[starts[highest(draw, bits, part_bits_)]++] = draw;
    insertion_sort(std::span(sorted),
                   [](const Draw& a, const Draw& b) { return bits_of(a) < bits_of(b); });
    Walk walk(*this);
    for (Draw& draw : sorted) {
        if (plan_.is_uniform_x())
            walk.invert_uniform_x(draw, random_bits(plan_.seed, first_number + draw.order).second);
        else if (plan_.is_space())
            walk.invert_in_space(draw, random_bits(plan_.seed, first_number + draw.order).second);
        else if (!widths_.empty())
            walk.invert_areas(draw);
        else
            walk.invert(draw);
    }
    std::copy(sorted.begin(), sorted.end(), part.begin());
}

std::span<const Draw> Marginal::invert(std::uint64_t first_number, std::uint32_t count) {
    return invert(first_number, count, {0, total()});
}

std::span<const Draw> Marginal::invert(std::uint64_t first_number, std::uint32_t count,
                                       CdfShare share) {
    find_bits(share);
    if (total() == 0) return {};
    draw_bits(first_number, count);
    workers_.for_columns(
        static_cast<std::uint32_t>(part_ends_.size()), draws_.size(), [&](std::uint32_t part) {
            const std::uint32_t begin = part == 0 ? 0 : part_ends_[part - 1];
            invert_part(first_number, draws_.subspan(begin, part_ends_[part] - begin));
        });
    if (plan_.is_uniform_x())  // ranks of uniform-x do not ascend with the bits
        insertion_sort(draws_, [](const Draw& a, const Draw& b) {
            return a.bin != b.bin ? a.bin < b.bin : a.rank < b.rank;
        });
    return draws_;
}

std::uint32_t Marginal::number_of(std::uint32_t order) const {
    return numbers_.empty() ? order : numbers_[order];
}

// Finds the random bits for which scaled(bits, total) lies in the CdfShare.
void Marginal::find_bits(CdfShare share) {
    __extension__ using Wide = unsigned __int128;
    const auto least = [&](std::uint64_t c) {
        return ((Wide{c} << 64) + share.total - 1) / share.total;
    };
    share_ = share;
    if (total() == 0) return;
    bits_.first = static_cast<std::uint64_t>(least(share.before));
    bits_.last = static_cast<std::uint64_t>(least(share.before + total()) - 1);
    bits_.shift = static_cast<unsigned>(std::min(std::countl_zero(bits_.last - bits_.first), 63));
}

}  // namespace lacuna
