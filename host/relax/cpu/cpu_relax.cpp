// Relaxation on threads. A task is a tile of the lattice.
#include "relax/cpu/cpu_relax.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "relax/cpu/nearest_point.h"
#include "relax/cpu/site_tree.h"
#include "relax/cpu/tile.h"
#include "relax/hilbert.h"

namespace lacuna::relaxing::cpu {
namespace {

// The pixel of each lattice point along an axis.
std::vector<std::uint32_t> pixels(std::uint32_t count, std::uint32_t cut) {
    std::vector<std::uint32_t> all(count);
    for (std::uint32_t i = 0; i < count; ++i) all[i] = i / cut;
    return all;
}

void add(std::uint64_t& sum, std::uint64_t more) {
    std::atomic_ref<std::uint64_t>(sum).fetch_add(more, std::memory_order_relaxed);
}

class CpuRelax : public RelaxBackend {
public:
    CpuRelax(const Lattice& lattice, std::span<const Site> sites, const Placement& placement,
             const Poll& poll)
        : lattice_(lattice),
          numbers_(lattice.numbers),
          workers_(placement.threads),
          indices_(hilbert_order(sites, poll)),
          sites_(sites.size()),
          moved_(sites.size()),
          shares_(sites.size()),
          pixel_of_column_(pixels(numbers_.columns, numbers_.cut_x)),
          pixel_of_row_(pixels(numbers_.rows, numbers_.cut_y)) {
        restore(sites);
        find_tiles(poll);
    }

    std::string device() const override { return workers_.name(); }

    // Also accumulates, so that the owners of lattice points need not be stored.
    void assign() override { assign_tiles({}); }
    void accumulate() override {}

    void move(std::uint32_t way) override {
        find_moved(way);
        sites_.swap(moved_);
    }

    void rest() override {
        find_moved(WHOLE_WAY);
        const auto is_lost = [&](const Site& site) { return lattice_.stored_below(site) == 0; };
        if (std::any_of(moved_.begin(), moved_.end(), is_lost)) {
            const PixelTree pixels(lattice_, [&] { workers_.poll(); });
            const Scene scene = this->scene();
            const auto find = [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    if (is_lost(moved_[i]))
                        moved_[i] = nearest_point(scene, pixels, static_cast<std::uint32_t>(i),
                                                  shares_[i].mass != 0, moved_[i]);
            };
            constexpr std::size_t kLostPerChunk = 256;  // a search takes up to 0.1 ms
            for_chunks(find, kLostPerChunk);
        }
        sites_.swap(moved_);
    }

    std::vector<Site> sites() override { return by_index(sites_); }
    std::vector<Share> shares() override { return by_index(shares_); }

    void restore(std::span<const Site> sites) override {
        for (std::size_t i = 0; i < indices_.size(); ++i) sites_[i] = sites[indices_[i]];
    }

    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    std::vector<std::uint32_t> owners() override {
        std::vector<std::uint32_t> owners(std::size_t{numbers_.columns} * numbers_.rows, NO_OWNER);
        assign_tiles(owners);
        return owners;
    }

private:
    Scene scene() const {
        return {lattice_, tree_, sites_, indices_, pixel_of_column_, pixel_of_row_};
    }

    // Finds the tiles with importance, and which of their leaves have any. A leaf's first hint is a
    // site inside it.
    void find_tiles(const Poll& poll) {
        const std::uint32_t tiles_of_row = (numbers_.columns - 1) / Tile::kSide + 1;
        std::vector<std::uint32_t> first_leaf(
            std::size_t{tiles_of_row} * ((numbers_.rows - 1) / Tile::kSide + 1), NO_OWNER);
        for (std::uint32_t y = 0; y < numbers_.rows; y += Tile::kSide) {
            poll();
            for (std::uint32_t x = 0; x < numbers_.columns; x += Tile::kSide) {
                const Box box{x, y, std::min(x + Tile::kSide, numbers_.columns),
                              std::min(y + Tile::kSide, numbers_.rows)};
                const std::uint32_t leaves = leaves_with_importance(box);
                if (leaves == 0) continue;
                first_leaf[std::size_t{y / Tile::kSide} * tiles_of_row + x / Tile::kSide] =
                    static_cast<std::uint32_t>(tiles_.size() * Tile::kLeaves);
                tiles_.push_back({box, leaves});
            }
        }
        hints_.resize(tiles_.size() * Tile::kLeaves);
        for (std::uint32_t i = 0; i < sites_.size(); ++i) {
            const std::uint32_t x = sites_[i].x / numbers_.step_x;
            const std::uint32_t y = sites_[i].y / numbers_.step_y;
            const std::uint32_t first =
                first_leaf[std::size_t{y / Tile::kSide} * tiles_of_row + x / Tile::kSide];
            if (first == NO_OWNER) continue;
            hints_[first + y % Tile::kSide / Tile::kLeaf * Tile::kLeavesOfSide +
                   x % Tile::kSide / Tile::kLeaf] = {i, std::numeric_limits<std::uint64_t>::max()};
        }
    }

    std::uint32_t leaves_with_importance(const Box& tile) const {
        std::uint32_t leaves = 0;
        for (std::uint32_t i = 0; i < Tile::kLeaves; ++i) {
            const Box leaf = Tile::leaf_of(tile, i);
            if (leaf.left < tile.right && leaf.bottom < tile.top && has_importance(leaf))
                leaves |= std::uint32_t{1} << i;
        }
        return leaves;
    }

    bool has_importance(const Box& box) const {
        for (std::uint32_t row = pixel_of_row_[box.bottom]; row <= pixel_of_row_[box.top - 1];
             ++row) {
            const auto first =
                lattice_.masses.begin() + static_cast<std::ptrdiff_t>(row) * numbers_.pixel_columns;
            if (std::any_of(first + pixel_of_column_[box.left],
                            first + pixel_of_column_[box.right - 1] + 1,
                            [](std::uint32_t mass) { return mass != 0; }))
                return true;
        }
        return false;
    }

    void assign_tiles(std::span<std::uint32_t> owners) {
        for_chunks([&](std::size_t begin, std::size_t end) {
            std::fill(shares_.begin() + static_cast<std::ptrdiff_t>(begin),
                      shares_.begin() + static_cast<std::ptrdiff_t>(end), Share{});
        });
        limit_weights();
        const Scene scene = this->scene();
        workers_.for_columns(
            static_cast<std::uint32_t>(tiles_.size()), lattice_.points, [&](std::uint32_t i) {
                Tile& tile = tile_of_thread_.local();
                const auto& [box, leaves] = tiles_[i];
                tile.assign(
                    scene, box, leaves,
                    std::span(hints_).subspan(std::size_t{i} * Tile::kLeaves, Tile::kLeaves),
                    owners);
                for (const Tile::Part& part : tile.parts()) add(part, box);
            });
    }

    // Limits weights by distances to the nearest sites, and leaves the tree with the new weights.
    void limit_weights() {
        tree_.look_at(sites_, workers_);
        const std::size_t blocks = (sites_.size() + SiteTree::kBlock - 1) / SiteTree::kBlock;
        constexpr std::size_t kBlocksPerTask = 16;
        const std::size_t tasks = (blocks + kBlocksPerTask - 1) / kBlocksPerTask;
        workers_.for_columns(
            static_cast<std::uint32_t>(tasks), sites_.size(), [&](std::uint32_t task) {
                const std::size_t end = std::min(blocks, (task + std::size_t{1}) * kBlocksPerTask);
                SiteTree::Neighbours near;
                for (std::size_t block = task * kBlocksPerTask; block < end; ++block)
                    limit_weights(block, near);
            });
        tree_.look_at(sites_, workers_);
    }

    void limit_weights(std::size_t block, SiteTree::Neighbours& near) {
        const std::size_t first = block * SiteTree::kBlock;
        const std::size_t count = std::min(sites_.size() - first, SiteTree::kBlock);
        std::array<std::uint64_t, SiteTree::kBlock> nearest{};
        const std::uint64_t even = portable::even_weight(numbers_.farthest);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t weight = sites_[first + i].weight;
            // No distance limits an even weight.
            nearest[i] = weight == even ? 0 : portable::reach_of_weight(numbers_.farthest, weight);
        }
        tree_.lower_to_nearest(block, numbers_.period_x, numbers_.period_y, near, nearest);
        for (std::size_t i = 0; i < count; ++i)
            sites_[first + i].weight =
                portable::bounded_weight(numbers_.farthest, sites_[first + i].weight, nearest[i]);
    }

    void add(const Tile::Part& part, const Box& box) {
        if (part.points == 0) return;
        const Site& site = sites_[part.image.site];
        Share& share = shares_[part.image.site];
        // portable::moment_offset of the box's lowest lattice point.
        const auto offset = [](std::uint32_t low, std::uint32_t at, std::uint32_t step,
                               std::uint32_t count, std::int32_t shift) {
            return static_cast<std::uint64_t>(std::int64_t{low} + count - at / step -
                                              std::int64_t{shift} * count);
        };
        cpu::add(share.points, part.points);
        cpu::add(share.mass, part.mass);
        cpu::add(share.moment_x,
                 part.moment_x + part.mass * offset(box.left, site.x, numbers_.step_x,
                                                    numbers_.columns, part.image.shift_x));
        cpu::add(share.moment_y,
                 part.moment_y + part.mass * offset(box.bottom, site.y, numbers_.step_y,
                                                    numbers_.rows, part.image.shift_y));
    }

    // Computes the new sites in moved_.
    void find_moved(std::uint32_t way) {
        for_chunks([&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                moved_[i] = moved(lattice_, sites_[i], shares_[i], way);
        });
    }

    // Calls work(begin, end) for runs of sites, in parallel.
    template <typename Work>
    void for_chunks(Work work, std::size_t sites_per_chunk = 1024) {
        const std::size_t chunks = (sites_.size() + sites_per_chunk - 1) / sites_per_chunk;
        workers_.for_columns(static_cast<std::uint32_t>(chunks), sites_.size(),
                             [&](std::uint32_t chunk) {
                                 const std::size_t begin = chunk * sites_per_chunk;
                                 work(begin, std::min(begin + sites_per_chunk, sites_.size()));
                             });
    }

    template <typename Value>
    std::vector<Value> by_index(const std::vector<Value>& values) const {
        std::vector<Value> sorted(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) sorted[indices_[i]] = values[i];
        return sorted;
    }

    const Lattice& lattice_;
    const portable::RelaxLattice& numbers_;
    Workers workers_;
    std::vector<std::uint32_t> indices_;  // of the sites below, in the order of Hilbert's curve
    std::vector<Site> sites_;
    std::vector<Site> moved_;
    std::vector<Share> shares_;
    SiteTree tree_;
    std::vector<std::uint32_t> pixel_of_column_;
    std::vector<std::uint32_t> pixel_of_row_;
    std::vector<std::pair<Box, std::uint32_t>> tiles_;  // and bits of leaves to assign
    std::vector<Hint> hints_;                           // one for each leaf
    tbb::enumerable_thread_specific<Tile> tile_of_thread_;
};

}  // namespace

std::unique_ptr<RelaxBackend> make_backend(const Lattice& lattice, std::span<const Site> sites,
                                           const Placement& placement, const Poll& poll) {
    return std::make_unique<CpuRelax>(lattice, sites, placement, poll);
}

}  // namespace lacuna::relaxing::cpu
