// A tile is cut into leaves. For each the sites are found that can win in it, and then all of them
// are tried on each of its lattice points.
#include "relax/cpu/tile.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace lacuna::relaxing::cpu {
namespace {

// What is summed of a leaf's lattice points, in one number: the masses, from bit 24 how many points
// have any, from bit 32 the masses times u. Of all 64 that is less than 2^22, 2^7 and 2^25.
constexpr std::uint64_t kOnePoint = 1u << 24;
constexpr int kMomentBits = 32;

// Two numbers that the compiler treats as one.
using Pair = double __attribute__((vector_size(16)));

std::int64_t place(std::uint32_t index, std::uint32_t step) {
    return portable::lattice_place(index, step);
}

}  // namespace

void Tile::own(const Scene& scene, const Box& box, Hint& hint, std::span<std::uint32_t> owners) {
    scene_ = &scene;
    left_ = box.left;
    bottom_ = box.bottom;
    owners_ = owners;
    find_candidates(box, hint);
    const Box all{0, 0, box.right - box.left, box.top - box.bottom};
    hint.site = parts_[candidates_[winner_in_middle(all)].part].image.site;
    for (std::uint32_t v = 0; v < all.top; v += kLeaf) {
        for (std::uint32_t u = 0; u < all.right; u += kLeaf) {
            const Box leaf{u, v, std::min(u + kLeaf, all.right), std::min(v + kLeaf, all.top)};
            keep_winners(leaf, candidates_[winner_in_middle(leaf)]);
            share_out(leaf);
        }
    }
}

// As an image of the domain sees the box that the domain itself sees.
Rectangle Tile::image_of(const Box& box, const Image& image) const {
    const portable::RelaxLattice& numbers = scene_->lattice.numbers;
    const std::int64_t x = std::int64_t{image.shift_x} * numbers.period_x;
    const std::int64_t y = std::int64_t{image.shift_y} * numbers.period_y;
    return {place(box.left, numbers.step_x) - x, place(box.right - 1, numbers.step_x) - x,
            place(box.bottom, numbers.step_y) - y, place(box.top - 1, numbers.step_y) - y};
}

void Tile::find_candidates(const Box& box, Hint& hint) {
    const SiteTree& tree = scene_->tree;
    candidates_.clear();
    parts_.clear();
    const int most = scene_->lattice.numbers.period_x != 0 ? 1 : 0;
    std::array<Image, 9> images;
    std::array<Rectangle, 9> boxes;
    std::size_t count = 0;
    for (int x = -most; x <= most; ++x) {
        for (int y = -most; y <= most; ++y) {
            images[count] = {0, static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
            boxes[count] = image_of(box, images[count]);
            ++count;
        }
    }
    std::uint64_t bound = std::numeric_limits<std::uint64_t>::max();
    if (hint.site != NO_OWNER)
        for (std::size_t i = 0; i < count; ++i)
            bound = std::min(bound, SiteTree::worst_power(scene_->sites[hint.site], boxes[i]));
    // Sites move little, as a rule; after a leap the bound would let far too many in.
    if (bound / 2 > hint.bound)
        for (std::size_t i = 0; i < count; ++i) bound = tree.least_worst_power(boxes[i], bound);
    hint.bound = bound;
    for (std::size_t i = 0; i < count; ++i)
        tree.find(boxes[i], bound, [&](std::uint32_t site) {
            add_candidate({site, images[i].shift_x, images[i].shift_y});
        });
}

// `at` does not overflow: of what power a candidate has where the tile is nearest to it, the bound
// leaves less than 2^62.
void Tile::add_candidate(const Image& image) {
    const portable::RelaxLattice& numbers = scene_->lattice.numbers;
    const Site& site = scene_->sites[image.site];
    const std::int64_t dx =
        site.x + std::int64_t{image.shift_x} * numbers.period_x - place(left_, numbers.step_x);
    const std::int64_t dy =
        site.y + std::int64_t{image.shift_y} * numbers.period_y - place(bottom_, numbers.step_y);
    // Of two images equally far away the one within the domain wins, as in moment_offset.
    const std::uint64_t order = std::uint64_t{scene_->indices[image.site]} * 4 +
                                (image.shift_x != 0 ? 1 : 0) + (image.shift_y != 0 ? 2 : 0);
    candidates_.push_back({dx * dx + dy * dy + static_cast<std::int64_t>(site.lift),
                           -2 * dx * numbers.step_x, -2 * dy * numbers.step_y, order,
                           static_cast<std::uint32_t>(parts_.size())});
    parts_.push_back({image, 0, 0, 0, 0});
}

std::size_t Tile::winner_in_middle(const Box& box) const {
    const std::int64_t u = (box.left + box.right) / 2;
    const std::int64_t v = (box.bottom + box.top) / 2;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::size_t winner = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const std::int64_t value = candidates_[i].value(u, v);
        winner = value < least ? i : winner;
        least = value < least ? value : least;
    }
    return winner;
}

// Those that the winner in the middle does not beat everywhere in the box: where two differ most
// lies in a corner. In the order of ties.
void Tile::keep_winners(const Box& box, const Candidate& winner) {
    winners_.clear();
    const std::int64_t u_low = box.left;
    const std::int64_t u_high = box.right - 1;
    const std::int64_t v_low = box.bottom;
    const std::int64_t v_high = box.top - 1;
    for (const Candidate& one : candidates_) {
        const std::int64_t along_x = one.along_x - winner.along_x;
        const std::int64_t along_y = one.along_y - winner.along_y;
        const std::int64_t most_ahead = one.at - winner.at +
                                        along_x * (along_x > 0 ? u_low : u_high) +
                                        along_y * (along_y > 0 ? v_low : v_high);
        if (most_ahead <= 0) winners_.push_back(one);
    }
    std::sort(winners_.begin(), winners_.end(),
              [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
}

void Tile::share_out(const Box& box) {
    fetch_masses(box);
    if (winners_.size() == 1)
        who_.fill(0);
    else if (!find_owners_fast(box))
        find_owners(box);
    add_to_parts(box);
    if (!owners_.empty()) write_owners(box);
}

// Outside of the box there is no mass: what is owned there counts for nothing.
void Tile::fetch_masses(const Box& box) {
    if (box.right - box.left < kLeaf || box.top - box.bottom < kLeaf) masses_.fill(0);
    const Lattice& lattice = scene_->lattice;
    const std::uint32_t width = box.right - box.left;
    const std::uint32_t* const pixels = &scene_->pixel_of_column[left_ + box.left];
    const bool one_each = lattice.numbers.cut_x == 1;
    std::array<std::uint32_t, kLeaf> masses{};
    std::uint32_t last_row = NO_OWNER;
    for (std::uint32_t v = 0; v < box.top - box.bottom; ++v) {
        const std::uint32_t row = scene_->pixel_of_row[bottom_ + box.bottom + v];
        if (row != last_row) {
            const std::uint16_t* const of_row =
                &lattice.mass[std::size_t{row} * lattice.numbers.pixel_columns];
            if (one_each && width == kLeaf)
                for (std::uint32_t u = 0; u < kLeaf; ++u) masses[u] = of_row[pixels[0] + u];
            else
                for (std::uint32_t u = 0; u < width; ++u) masses[u] = of_row[pixels[u]];
            last_row = row;
        }
        for (std::uint32_t u = 0; u < kLeaf; ++u)
            masses_[v * kLeaf + u] = masses[u] + (masses[u] != 0 ? kOnePoint : 0) +
                                     (std::uint64_t{masses[u]} * u << kMomentBits);
    }
}

// Doubles hold the whole numbers that are compared exactly, 2^kOrderBits times what a candidate is
// ahead of the first one plus its place in the list; processors have their minimum in one
// instruction, and the least of all tells both. False where that needs more than 2^51, and nothing
// is done.
bool Tile::find_owners_fast(const Box& box) {
    constexpr int kOrderBits = 5;
    constexpr std::int64_t kMost = std::int64_t{1} << kOrderBits;
    constexpr std::int64_t kMostDifference = std::int64_t{1} << 41;  // times 2^5, and 2 * 8 + 1
    // 1.5 * 2^52: in a sum with it the lowest bits of a double are those of a whole number.
    constexpr double kShow = 6755399441055744.0;
    constexpr std::size_t kPairs = kLeaf / 2;
    using Row = std::array<Pair, kPairs>;
    const std::size_t count = winners_.size();
    if (count > std::size_t{kMost}) return false;
    const Candidate& first = winners_.front();
    const auto fits = [](std::int64_t number) {
        return number > -kMostDifference && number < kMostDifference;
    };
    std::array<Row, kMost> rows;
    std::array<double, kMost> up;
    for (std::size_t i = 0; i < count; ++i) {
        const Candidate& one = winners_[i];
        const std::int64_t at = one.value(box.left, box.bottom) - first.value(box.left, box.bottom);
        const std::int64_t along_x = one.along_x - first.along_x;
        const std::int64_t along_y = one.along_y - first.along_y;
        if (!fits(at) || !fits(along_x) || !fits(along_y)) return false;
        const auto start = static_cast<double>(at * kMost + static_cast<std::int64_t>(i));
        const auto step = static_cast<double>(along_x * kMost);
        Pair pair{start, start + step};
        for (std::size_t u = 0; u < kPairs; ++u) {
            rows[i][u] = pair;
            pair += 2 * step;
        }
        up[i] = static_cast<double>(along_y * kMost);
    }
    for (std::size_t v = 0; v < kLeafPoints; v += kLeaf) {
        Row least = rows[0];  // which is the same in all rows
        for (std::size_t i = 1; i < count; ++i) {
            for (std::size_t u = 0; u < kPairs; ++u) {
                const Pair pair = rows[i][u];
                least[u] = pair < least[u] ? pair : least[u];
                rows[i][u] = pair + up[i];
            }
        }
        for (std::size_t u = 0; u < kPairs; ++u) {
            const Pair shown = least[u] + kShow;
            who_[v + 2 * u] = std::bit_cast<std::uint64_t>(shown[0]) % std::uint64_t{kMost};
            who_[v + 2 * u + 1] = std::bit_cast<std::uint64_t>(shown[1]) % std::uint64_t{kMost};
        }
    }
    return true;
}

void Tile::find_owners(const Box& box) {
    for (std::uint32_t v = 0; v < kLeaf; ++v) {
        for (std::uint32_t u = 0; u < kLeaf; ++u) {
            std::int64_t least = std::numeric_limits<std::int64_t>::max();
            for (std::uint32_t i = 0; i < winners_.size(); ++i) {
                const std::int64_t value = winners_[i].value(box.left + u, box.bottom + v);
                if (value >= least) continue;
                least = value;
                who_[v * kLeaf + u] = i;
            }
        }
    }
}

void Tile::add_to_parts(const Box& box) {
    sums_.assign(winners_.size(), {0, 0});
    // From the top: after each row all sums so far are added once more, so that the masses of row v
    // are added v times.
    for (std::size_t v = kLeaf; v-- > 0;) {
        for (std::size_t u = 0; u < kLeaf; ++u)
            sums_[who_[v * kLeaf + u]].packed += masses_[v * kLeaf + u];
        if (v == 0) break;
        for (Sum& sum : sums_) sum.moment_y += sum.packed % kOnePoint;
    }
    for (std::size_t i = 0; i < winners_.size(); ++i) {
        const auto [packed, moment_y] = sums_[i];
        if (packed == 0) continue;
        Part& part = parts_[winners_[i].part];
        const std::uint64_t mass = packed % kOnePoint;
        part.points +=
            static_cast<std::uint32_t>(packed % (std::uint64_t{1} << kMomentBits) / kOnePoint);
        part.mass += mass;
        part.moment_x += (packed >> kMomentBits) + mass * box.left;
        part.moment_y += moment_y + mass * box.bottom;
    }
}

void Tile::write_owners(const Box& box) {
    for (std::uint32_t v = box.bottom; v < box.top; ++v) {
        for (std::uint32_t u = box.left; u < box.right; ++u) {
            const std::size_t point = std::size_t{v - box.bottom} * kLeaf + (u - box.left);
            if (masses_[point] == 0) continue;
            owners_[std::size_t{bottom_ + v} * scene_->lattice.numbers.columns + left_ + u] =
                scene_->indices[parts_[winners_[who_[point]].part].image.site];
        }
    }
}

}  // namespace lacuna::relaxing::cpu
