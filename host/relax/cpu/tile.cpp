// Finds the sites that can win in a tile, and puts them into the order that decides ties.
// tile_leaf.cpp then assigns the lattice points leaf by leaf.
#include "relax/cpu/tile.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace lacuna::relaxing::cpu {
namespace {

std::int64_t place(std::uint32_t index, std::uint32_t step) {
    return portable::lattice_place(index, step);
}

// The distance from `at` to the farther end of an interval, by the image of it that is nearest.
std::uint64_t worst_distance(std::int64_t at, std::int64_t low, std::int64_t high,
                             std::int64_t period) {
    const auto farther = [&](std::int64_t from) {
        return static_cast<std::uint64_t>(std::max(std::abs(from - low), std::abs(from - high)));
    };
    if (period == 0) return farther(at);
    return std::min({farther(at), farther(at - period), farther(at + period)});
}

}  // namespace

Box Tile::leaf_of(const Box& tile, std::uint32_t i) {
    const std::uint32_t left = tile.left + i % kLeavesOfSide * kLeaf;
    const std::uint32_t bottom = tile.bottom + i / kLeavesOfSide * kLeaf;
    return {left, bottom, std::min(left + kLeaf, tile.right), std::min(bottom + kLeaf, tile.top)};
}

void Tile::assign(const Scene& scene, const Box& box, std::uint32_t leaves, std::span<Hint> hints,
                  std::span<std::uint32_t> owners) {
    scene_ = &scene;
    box_ = box;
    owners_ = owners;
    find_images();
    std::uint64_t bound = 0;
    for (std::uint32_t rest = leaves; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
        bound = std::max(bound, bound_in(leaf_of(box, i), hints[i]));
    }
    find_candidates(bound);
    const Box all{0, 0, box.right - box.left, box.top - box.bottom};
    for (std::uint32_t rest = leaves; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
        const Box leaf = leaf_of(all, i);
        share_out(leaf);
        const std::size_t middle =
            std::size_t{(leaf.top - leaf.bottom) / 2} * kLeaf + (leaf.right - leaf.left) / 2;
        hints[i].site = parts_[who_[middle]].image.site;
    }
}

void Tile::find_images() {
    image_count_ = 0;
    const int most = scene_->lattice.numbers.period_x != 0 ? 1 : 0;
    for (int x = -most; x <= most; ++x)
        for (int y = -most; y <= most; ++y)
            images_[image_count_++] = {0, static_cast<std::int16_t>(x),
                                       static_cast<std::int16_t>(y)};
}

// Every site that can win in the leaf has at most this power somewhere in it.
std::uint64_t Tile::bound_in(const Box& leaf, Hint& hint) const {
    const portable::RelaxLattice& numbers = scene_->lattice.numbers;
    std::uint64_t bound = std::numeric_limits<std::uint64_t>::max();
    if (hint.site != NO_OWNER) {
        const Site& site = scene_->sites[hint.site];
        const Rectangle at = image_of(leaf, {});
        const std::uint64_t dx = worst_distance(site.x, at.left, at.right, numbers.period_x);
        const std::uint64_t dy = worst_distance(site.y, at.bottom, at.top, numbers.period_y);
        bound = dx * dx + dy * dy + site.weight;
    }
    // Usually sites move little. After a large move this bound would admit far too many sites.
    if (bound / 2 > hint.bound)
        for (std::size_t i = 0; i < image_count_; ++i)
            bound = scene_->tree.least_worst_power(image_of(leaf, images_[i]), bound);
    hint.bound = bound;
    return bound;
}

// The box as seen from an image of the domain.
Rectangle Tile::image_of(const Box& box, const Image& image) const {
    const portable::RelaxLattice& numbers = scene_->lattice.numbers;
    const std::int64_t x = std::int64_t{image.shift_x} * numbers.period_x;
    const std::int64_t y = std::int64_t{image.shift_y} * numbers.period_y;
    return {place(box.left, numbers.step_x) - x, place(box.right - 1, numbers.step_x) - x,
            place(box.bottom, numbers.step_y) - y, place(box.top - 1, numbers.step_y) - y};
}

void Tile::find_candidates(std::uint64_t bound) {
    candidates_.clear();
    order_.clear();
    for (std::size_t i = 0; i < image_count_; ++i) {
        Image image = images_[i];
        scene_->tree.find(image_of(box_, image), bound, [&](std::uint32_t site) {
            image.site = site;
            add_candidate(image);
        });
    }
    if (!std::is_sorted(order_.begin(), order_.end())) std::sort(order_.begin(), order_.end());
    parts_.clear();
    for (const std::uint64_t key : order_)
        parts_.push_back({candidates_[key % kMostCandidates].image, 0, 0, 0, 0});
    sums_.resize(candidates_.size());
    has_doubles_ = fill_doubles();
    if (!has_doubles_) fill_whole();
}

// Cannot overflow: the bound limits a candidate's power at the tile's nearest lattice point to less
// than 2^62.
void Tile::add_candidate(const Image& image) {
    const portable::RelaxLattice& numbers = scene_->lattice.numbers;
    const Site& site = scene_->sites[image.site];
    const std::int64_t dx =
        site.x + std::int64_t{image.shift_x} * numbers.period_x - place(box_.left, numbers.step_x);
    const std::int64_t dy = site.y + std::int64_t{image.shift_y} * numbers.period_y -
                            place(box_.bottom, numbers.step_y);
    // If two images are equally far away, the one in the domain wins, as in moment_offset.
    const std::uint64_t order = std::uint64_t{scene_->indices[image.site]} * 4 +
                                (image.shift_x != 0 ? 1 : 0) + (image.shift_y != 0 ? 2 : 0);
    order_.push_back(order * kMostCandidates + candidates_.size());
    candidates_.push_back({dx * dx + dy * dy + static_cast<std::int64_t>(site.weight),
                           -2 * dx * numbers.step_x, -2 * dy * numbers.step_y, image});
}

template <typename Number>
void Tile::Planes<Number>::resize(std::size_t count) {
    for (std::vector<Number>* plane : {&at, &along_x, &along_y, &in_leaf, &behind})
        plane->resize(count);
}

// Returns false if the numbers do not fit into doubles.
bool Tile::fill_doubles() {
    if (candidates_.size() > kMost) return false;
    const auto fits = [](std::int64_t number) {
        return number > -kMostDifference && number < kMostDifference;
    };
    const auto scaled = [](std::int64_t number) {
        return static_cast<double>(number * static_cast<std::int64_t>(kMost));
    };
    doubles_.resize(candidates_.size());
    const Candidate& first = candidates_.front();
    bool all_fit = true;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const Candidate& one = candidates_[order_[i] % kMostCandidates];
        const std::int64_t at = one.at - first.at;
        const std::int64_t along_x = one.along_x - first.along_x;
        const std::int64_t along_y = one.along_y - first.along_y;
        all_fit = all_fit && fits(at) && fits(along_x) && fits(along_y);
        if (!all_fit) break;
        doubles_.at[i] = scaled(at) + static_cast<double>(i);
        doubles_.along_x[i] = scaled(along_x);
        doubles_.along_y[i] = scaled(along_y);
    }
    return all_fit;
}

void Tile::fill_whole() {
    whole_.resize(candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const Candidate& one = candidates_[order_[i] % kMostCandidates];
        whole_.at[i] = one.at;
        whole_.along_x[i] = one.along_x;
        whole_.along_y[i] = one.along_y;
    }
}

}  // namespace lacuna::relaxing::cpu
