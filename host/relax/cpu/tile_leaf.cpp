// Assigns a leaf of a tile: keeps the tile's candidates that can win in the leaf, then tries all of
// these on each of its lattice points.
#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "relax/cpu/tile.h"
#include "relax/cpu/wide.h"

namespace lacuna::relaxing::cpu {
namespace {

// Three sums over a leaf's lattice points in one number: masses, from bit 28 the count of points
// with mass, from bit 35 masses times u. For 64 points they are below 2^27, 2^7 and 2^29.
constexpr std::uint64_t kOnePoint = 1u << 28;
constexpr int kMomentBits = 35;
// What a mass of 1 adds to these sums in each column of a leaf, without the count.
constexpr auto kInColumn = [] {
    std::array<std::uint64_t, Tile::kLeaf> sums{};
    for (std::uint64_t u = 0; u < Tile::kLeaf; ++u) sums[u] = 1 + (u << kMomentBits);
    return sums;
}();

}  // namespace

std::uint32_t Tile::place_in_list(double value) {
    // After adding 1.5 * 2^52 the lowest bits of a double are the whole number's.
    constexpr double kShow = 6755399441055744.0;
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(value + kShow) % kMost);
}

// The candidate with the least power in the leaf's middle. Its double contains its index.
LACUNA_WIDE
std::size_t Tile::first_in_middle(const Planes<double>& planes, double right, double up) {
    constexpr std::size_t kLanes = 4;
    std::array<double, kLanes> least;
    least.fill(std::numeric_limits<double>::infinity());
    const std::size_t count = planes.at.size();
    const auto value = [&](std::size_t i) {
        return planes.in_leaf[i] + right * planes.along_x[i] + up * planes.along_y[i];
    };
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const double one = value(i + lane);
            least[lane] = one < least[lane] ? one : least[lane];
        }
    }
    for (; i < count; ++i) least[0] = std::min(least[0], value(i));
    return place_in_list(*std::min_element(least.begin(), least.end()));
}

std::size_t Tile::first_in_middle(const Planes<std::int64_t>& planes, std::int64_t right,
                                  std::int64_t up) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::size_t first = 0;
    for (std::size_t i = 0; i < planes.at.size(); ++i) {
        const std::int64_t value =
            planes.in_leaf[i] + right * planes.along_x[i] + up * planes.along_y[i];
        if (value >= least) continue;
        least = value;
        first = i;
    }
    return first;
}

// How far each candidate is behind the first in the middle: the least over all corners.
template <typename Number>
[[gnu::always_inline]] inline void Tile::find_how_far_behind(Planes<Number>& planes,
                                                             std::size_t first, Number width,
                                                             Number height) {
    const Number at = planes.in_leaf[first];
    const Number along_x = planes.along_x[first];
    const Number along_y = planes.along_y[first];
    for (std::size_t i = 0; i < planes.at.size(); ++i) {
        const Number right = width * (planes.along_x[i] - along_x);
        const Number up = height * (planes.along_y[i] - along_y);
        planes.behind[i] =
            planes.in_leaf[i] - at + std::min(right, Number{0}) + std::min(up, Number{0});
    }
}

LACUNA_WIDE void Tile::find_behind(Planes<double>& planes, std::size_t first, double width,
                                   double height) {
    find_how_far_behind(planes, first, width, height);
}

void Tile::find_behind(Planes<std::int64_t>& planes, std::size_t first, std::int64_t width,
                       std::int64_t height) {
    find_how_far_behind(planes, first, width, height);
}

// Keeps the candidates that the first in the middle does not beat everywhere in the leaf. The
// largest difference is in a corner. `slack` is what indices in the list can add to a difference.
template <typename Number>
void Tile::keep_winners(Planes<Number>& planes, const Box& leaf, Number slack) {
    const std::size_t count = planes.at.size();
    const auto left = static_cast<Number>(leaf.left);
    const auto bottom = static_cast<Number>(leaf.bottom);
    for (std::size_t i = 0; i < count; ++i)
        planes.in_leaf[i] = planes.at[i] + left * planes.along_x[i] + bottom * planes.along_y[i];
    const std::uint32_t right_of_middle = (leaf.right - leaf.left) / 2;
    const std::uint32_t up_to_middle = (leaf.top - leaf.bottom) / 2;
    const std::size_t first = first_in_middle(planes, static_cast<Number>(right_of_middle),
                                              static_cast<Number>(up_to_middle));
    find_behind(planes, first, static_cast<Number>(leaf.right - leaf.left - 1),
                static_cast<Number>(leaf.top - leaf.bottom - 1));
    winners_.resize(count);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        winners_[kept] = static_cast<std::uint32_t>(i);
        kept += std::size_t{planes.behind[i] <= slack};
    }
    winners_.resize(kept);
}

void Tile::share_out(const Box& leaf) {
    if (has_doubles_)
        keep_winners(doubles_, leaf, static_cast<double>(kMost - 1));
    else
        keep_winners(whole_, leaf, std::int64_t{0});
    fetch_masses(leaf);
    if (winners_.size() == 1)
        who_.fill(winners_.front());
    else if (has_doubles_)
        find_owners_of_doubles();
    else
        find_owners();
    add_to_parts(leaf);
    if (!owners_.empty()) write_owners(leaf);
}

// Points outside the lattice get mass 0, so that they add nothing.
void Tile::fetch_masses(const Box& leaf) {
    const std::uint32_t width = leaf.right - leaf.left;
    if (width < kLeaf || leaf.top - leaf.bottom < kLeaf) masses_.fill(0);
    const Lattice& lattice = scene_->lattice;
    exponent_ = lattice.exponent_at(box_.left + leaf.left, box_.bottom + leaf.bottom);
    const std::uint32_t* const pixels = &scene_->pixel_of_column[box_.left + leaf.left];
    std::uint32_t last_row = NO_OWNER;
    for (std::uint32_t v = 0; v < leaf.top - leaf.bottom; ++v) {
        const std::uint32_t row = scene_->pixel_of_row[box_.bottom + leaf.bottom + v];
        std::uint64_t* const of_row = &masses_[std::size_t{v} * kLeaf];
        if (row == last_row) {
            std::copy(of_row - kLeaf, of_row, of_row);
            continue;
        }
        last_row = row;
        const std::uint32_t* const masses =
            &lattice.masses[std::size_t{row} * lattice.numbers.pixel_columns];
        const auto fetch = [&](std::uint32_t u, std::uint64_t mass) {
            of_row[u] = mass * kInColumn[u] + (mass != 0 ? kOnePoint : 0);
        };
        if (exponent_ != 0)
            for (std::uint32_t u = 0; u < width; ++u)
                fetch(u, portable::mass_in_leaf(masses[pixels[u]], exponent_));
        else if (width == kLeaf)  // nearly always: a loop of fixed length
            for (std::uint32_t u = 0; u < kLeaf; ++u) fetch(u, masses[pixels[u]]);
        else
            for (std::uint32_t u = 0; u < width; ++u) fetch(u, masses[pixels[u]]);
    }
}

// Half a row of four rows at a time, so that the least values stay in registers.
LACUNA_WIDE void Tile::find_owners_of_doubles() {
    constexpr std::size_t kHalves = 2, kHalf = kLeaf / kHalves, kRows = 4;
    const std::size_t count = winners_.size();
    rows_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t one = winners_[i];
        const double step = doubles_.along_x[one];
        rows_[i].first[0] = doubles_.in_leaf[one] + step * Four{0, 1, 2, 3};
        rows_[i].first[1] = rows_[i].first[0] + kHalf * step;
        rows_[i].up = Four{} + doubles_.along_y[one];
    }
    for (std::size_t row = 0; row < kLeaf; row += kRows) {
        for (std::size_t half = 0; half < kHalves; ++half) {
            Four least[kRows];
            for (Four& one : least) one = Four{} + std::numeric_limits<double>::infinity();
            for (Row& one : rows_) {
                Four value = one.first[half];
                for (std::size_t v = 0; v < kRows; ++v) {
                    least[v] = value < least[v] ? value : least[v];
                    value += one.up;
                }
                one.first[half] = value;
            }
            for (std::size_t v = 0; v < kRows; ++v)
                for (std::size_t u = 0; u < kHalf; ++u)
                    who_[(row + v) * kLeaf + half * kHalf + u] = place_in_list(least[v][u]);
        }
    }
}

void Tile::find_owners() {
    for (std::uint32_t v = 0; v < kLeaf; ++v) {
        for (std::uint32_t u = 0; u < kLeaf; ++u) {
            std::int64_t least = std::numeric_limits<std::int64_t>::max();
            for (const std::uint32_t one : winners_) {
                const std::int64_t value =
                    whole_.in_leaf[one] + u * whole_.along_x[one] + v * whole_.along_y[one];
                if (value >= least) continue;
                least = value;
                who_[v * kLeaf + u] = one;
            }
        }
    }
}

void Tile::add_to_parts(const Box& leaf) {
    for (const std::uint32_t one : winners_) sums_[one] = {};
    // Rows are added from the top. After each row the sums up to there are added to the moment, so
    // that the masses of row v are added v times.
    for (std::size_t v = kLeaf; v-- > 0;) {
        for (std::size_t u = 0; u < kLeaf; ++u)
            sums_[who_[v * kLeaf + u]].packed[u % kChains] += masses_[v * kLeaf + u];
        if (v == 0) break;
        for (const std::uint32_t one : winners_)
            sums_[one].moment_y += sums_[one].all() % kOnePoint;
    }
    const std::uint32_t exponent = exponent_;
    for (const std::uint32_t one : winners_) {
        const std::uint64_t packed = sums_[one].all();
        if (packed == 0) continue;
        Part& part = parts_[one];
        const std::uint64_t mass = packed % kOnePoint;
        part.points +=
            static_cast<std::uint32_t>(packed % (std::uint64_t{1} << kMomentBits) / kOnePoint);
        part.mass += mass << exponent;
        part.moment_x += ((packed >> kMomentBits) + mass * leaf.left) << exponent;
        part.moment_y += (sums_[one].moment_y + mass * leaf.bottom) << exponent;
    }
}

void Tile::write_owners(const Box& leaf) {
    for (std::uint32_t v = leaf.bottom; v < leaf.top; ++v) {
        for (std::uint32_t u = leaf.left; u < leaf.right; ++u) {
            const std::size_t point = std::size_t{v - leaf.bottom} * kLeaf + (u - leaf.left);
            if (masses_[point] == 0) continue;
            owners_[std::size_t{box_.bottom + v} * scene_->lattice.numbers.columns + box_.left +
                    u] = scene_->indices[parts_[who_[point]].image.site];
        }
    }
}

}  // namespace lacuna::relaxing::cpu
