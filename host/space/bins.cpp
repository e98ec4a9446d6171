// Splits bins, and drops those that one sample covers.
#include "space/bins.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace lacuna::space {
namespace {

constexpr std::size_t kBinsInRun = 2048;  // some milliseconds of work

std::uint64_t rounded_up_root(std::uint64_t square) {
    return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(square))) + 2;
}

std::uint64_t squared(std::int64_t way) {
    return static_cast<std::uint64_t>(way * way);
}

// Finds which pieces of a part no sample covers. What is covered by one sample is so if its corners
// are.
class Splitting {
public:
    Splitting(const FirstBins& all, std::uint64_t radius_squared, std::uint32_t block,
              const std::vector<Position>& near)
        : all_(all), radius_squared_(radius_squared), near_(near) {
        if (all.is_volume()) cell_ = all.cell(block);
    }

    bool can_split(const Portion& part) const {
        if (!all_.is_volume()) return !is_corner(part);
        return !is_unit(low_corner(cell_, part), high_corner(cell_, part));
    }
    // A bit for each piece that stays, or bit 0 for a part that stays as it is.
    unsigned kept_of(const Portion& part, bool splits) {
        return all_.is_volume() ? kept_of_box(part, splits) : kept_of_triangle(part, splits);
    }

private:
    bool is_closer(const Position& sample, const Position& corner) const {
        return squared_distance(sample, corner) < radius_squared_;
    }

    unsigned kept_of_triangle(const Portion& part, bool splits) {
        const Solid& triangle = all_.triangles[part.third];
        const Position a = corner_of_triangle(triangle, part, 0);
        const Position b = corner_of_triangle(triangle, part, 1);
        const Position c = corner_of_triangle(triangle, part, 2);
        // A sample that covers something is closer to `a` than the radius and the longest side.
        const std::uint64_t reach =
            rounded_up_root(radius_squared_) +
            rounded_up_root(std::max(squared_distance(a, b), squared_distance(a, c)));
        const std::uint64_t squared_reach = reach * reach;
        reaching_.clear();
        for (const Position& sample : near_) {
            const std::uint64_t distance = squared_distance(sample, a);
            if (distance >= squared_reach) continue;
            if (distance < radius_squared_ && is_closer(sample, b) && is_closer(sample, c))
                return 0;
            reaching_.push_back(sample);
        }
        if (!splits) return 1;
        // The pieces have six corners: those of the part, and those of the piece in the middle,
        // which are opposite to them.
        const Portion middle = quarter(part, 3);
        const Position opposite_a = corner_of_triangle(triangle, middle, 0);
        const Position opposite_b = corner_of_triangle(triangle, middle, 1);
        const Position opposite_c = corner_of_triangle(triangle, middle, 2);
        unsigned kept = 15;
        for (const Position& sample : reaching_) {
            const bool at_a = is_closer(sample, opposite_a), at_b = is_closer(sample, opposite_b),
                       at_c = is_closer(sample, opposite_c);
            if (at_b && at_c && is_closer(sample, a)) kept &= ~1U;
            if (at_a && at_c && is_closer(sample, b)) kept &= ~2U;
            if (at_a && at_b && is_closer(sample, c)) kept &= ~4U;
            if (at_a && at_b && at_c) kept &= ~8U;
            if (kept == 0) break;
        }
        return kept;
    }

    // The squared distances of a sample and the farther end of a part of an axis, and of each half.
    struct Farther {
        std::uint64_t all;
        std::array<std::uint64_t, 2> half;
    };
    static Farther farther(std::int64_t at, std::int64_t low, std::int64_t middle,
                           std::int64_t high) {
        const std::uint64_t to_low = squared(at - low), to_middle = squared(at - middle),
                            to_high = squared(at - high);
        return {std::max(to_low, to_high),
                {std::max(to_low, to_middle), std::max(to_middle, to_high)}};
    }

    unsigned kept_of_box(const Portion& part, bool splits) const {
        const Position low = low_corner(cell_, part), high = high_corner(cell_, part);
        const Position middle = low_corner(cell_, eighth(part, 7));
        const bool is_one = is_unit(low, high);
        const Position end = is_one ? low : high;
        unsigned kept = splits ? parts_with_volume(low, middle, high) : 1;
        // Pieces of one unit are their low corners. All others have the middle as a corner.
        const bool makes_units = has_units(low, middle, high);
        for (const Position& sample : near_) {
            if (!makes_units && !is_closer(sample, middle)) continue;
            const Farther x = farther(sample.x, low.x, middle.x, end.x);
            const Farther y = farther(sample.y, low.y, middle.y, end.y);
            const Farther z = farther(sample.z, low.z, middle.z, end.z);
            if (x.all + y.all + z.all < radius_squared_) return 0;
            if (!splits) continue;
            for (unsigned i = 0; i < 8 && !makes_units; ++i)
                if (x.half[i & 1U] + y.half[i >> 1U & 1U] + z.half[i >> 2U] < radius_squared_)
                    kept &= ~(1U << i);
            for (unsigned i = 0; i < 8 && makes_units; ++i) {
                const Portion piece = eighth(part, i);
                const Position from = low_corner(cell_, piece), to = high_corner(cell_, piece);
                const Position far = is_unit(from, to) ? from : to;
                if (squared_distance_to_farthest(sample, from, far) < radius_squared_)
                    kept &= ~(1U << i);
            }
            if (kept == 0) break;
        }
        return kept;
    }
    const FirstBins& all_;
    std::uint64_t radius_squared_;
    const std::vector<Position>& near_;
    std::vector<Position> reaching_;
    Solid cell_{};
};

}  // namespace

Bins::Bins(const FirstBins& all, std::uint64_t radius_squared, Workers& workers)
    : all_(all), radius_squared_(radius_squared), now_(all.bins) {
    for (std::uint32_t block = 0; block < all.blocks(); ++block) {
        if (all.begins[block] == all.begins[block + 1]) continue;
        blocks_.push_back(block);
        begins_.push_back(all.begins[block]);
    }
    begins_.push_back(static_cast<std::uint32_t>(size()));
    find_runs();
    weigh(workers);
}

void Bins::find_runs() {
    run_begins_ = {0};
    for (std::uint32_t i = 0; i < blocks(); ++i)
        if (begins_[i + 1] - begins_[run_begins_.back()] >= kBinsInRun)
            run_begins_.push_back(i + 1);
    if (run_begins_.back() != blocks()) run_begins_.push_back(blocks());
}

void Bins::mark(const Samples& samples, Span blocks) {
    std::vector<Position> near;
    for (std::uint32_t i = blocks.begin; i < blocks.end; ++i) {
        samples.find_near(block(i), near);
        Splitting splitting(all_, radius_squared_, block(i), near);
        for (std::uint32_t bin = begin(i); bin < begin(i + 1); ++bin) {
            const bool splits = std::uint64_t{lengths_[bin]} * widths_[bin] >= least_to_split_ &&
                                splitting.can_split(now_[bin]);
            kept_[bin] = static_cast<std::uint16_t>(splitting.kept_of(now_[bin], splits) |
                                                    (splits ? kSplits : 0U));
        }
    }
}

// Puts the pieces that stay in place of the bins.
void Bins::take_marked(Workers& workers) {
    std::vector<std::uint32_t> blocks, begins, firsts;
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < this->blocks(); ++i) {
        const std::uint32_t before = sum;
        for (std::uint32_t bin = begin(i); bin < begin(i + 1); ++bin)
            sum += static_cast<std::uint32_t>(std::popcount(kept_[bin] & (kSplits - 1U)));
        firsts.push_back(before);
        if (sum == before) continue;
        blocks.push_back(block(i));
        begins.push_back(before);
    }
    begins.push_back(sum);
    std::vector<Portion> pieces(sum);
    workers.for_columns(runs(), size(), [&](std::uint32_t of_run) {
        Portion* next = pieces.data() + firsts[run(of_run).begin];
        for (std::uint32_t i = run(of_run).begin; i < run(of_run).end; ++i)
            for (std::uint32_t bin = begin(i); bin < begin(i + 1); ++bin) {
                const Portion& part = now_[bin];
                const bool splits = (kept_[bin] & kSplits) != 0;
                for (unsigned kept = kept_[bin] & (kSplits - 1U); kept != 0; kept &= kept - 1) {
                    const auto which = static_cast<std::uint32_t>(std::countr_zero(kept));
                    *next++ = splits ? piece_of(all_, part, which) : part;
                }
            }
    });
    pieces_ = std::move(pieces);
    now_ = pieces_;
    blocks_ = std::move(blocks);
    begins_ = std::move(begins);
    find_runs();
}

void Bins::refine(const Samples& samples, bool halve, Workers& workers) {
    kept_.resize(size());
    constexpr std::uint64_t kNone = ~std::uint64_t{0};
    least_to_split_ = halve ? least_weight_to_split(total_, size()) : kNone;
    workers.for_columns(runs(), size(), [&](std::uint32_t i) { mark(samples, run(i)); });
    std::vector<std::uint32_t>().swap(lengths_);  // not needed while bins take most memory
    std::vector<std::uint32_t>().swap(widths_);
    take_marked(workers);
    weigh(workers);
}

void Bins::weigh(Workers& workers) {
    lengths_.resize(size());
    widths_.resize(size());
    workers.for_columns(runs(), size(), [&](std::uint32_t i) {
        for (std::uint32_t k = run(i).begin; k < run(i).end; ++k) {
            const Solid cell = all_.is_volume() ? all_.cell(block(k)) : Solid{};
            for (std::uint32_t bin = begin(k); bin < begin(k + 1); ++bin) {
                const auto [length, width] = size_of(all_.weight_of(now_[bin], cell));
                lengths_[bin] = length;
                widths_[bin] = width;
            }
        }
    });
    total_ = 0;
    for (std::size_t bin = 0; bin < size(); ++bin)
        total_ += std::uint64_t{lengths_[bin]} * widths_[bin];
}

}  // namespace lacuna::space
