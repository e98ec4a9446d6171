// Relaxation on a device. Tiles come in batches, which all use one set of buffers for tables.
#include "relax/device/device_relax.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "portable/failure.h"
#include "portable/report.h"
#include "portable/site_tree.h"
#include "relax/cpu/nearest_point.h"
#include "relax/cpu/site_tree.h"
#include "relax/device/memory.h"
#include "relax/hilbert.h"

namespace lacuna::relaxing::device {
namespace {

namespace kernels = lacuna::device::kernels;
using lacuna::device::Buffer;

// Units in a batch: a processor's caches should hold its tables; a graphics card needs many.
constexpr std::uint32_t kUnitsOfProcessor = 1024;
constexpr std::uint32_t kUnitsOfGraphics = 4096;

// Work for Queue::launch, in tenths of a microsecond: of finding a unit's rivals, of a leaf's
// lattice points, of a row in a crowded leaf, of a site, of a leaf of the tree over the sites.
constexpr std::uint64_t kFindWork = 100;
constexpr std::uint64_t kLeafWork = 20;
constexpr std::uint64_t kCrowdedWork = 20;
constexpr std::uint64_t kSiteWork = 1;
constexpr std::uint64_t kLimitWork = 40;

// Number of sites that rest() searches importance for between two polls: at most 0.1 s.
constexpr std::uint32_t kSitesBetweenPolls = 1024;

// Vectors as a device stores them.
using Words2 = std::array<std::uint32_t, 2>;
using Words4 = std::array<std::uint32_t, 4>;

Words4 packed(const Site& site) {
    return {site.x, site.y, portable::to_u32(site.weight), portable::to_u32(site.weight >> 32)};
}

class DeviceRelax : public RelaxBackend {
public:
    DeviceRelax(std::unique_ptr<Queue> queue, const Lattice& lattice, std::span<const Site> sites,
                const Tuning& tuning, const Poll& poll)
        : queue_(std::move(queue)),
          lattice_(lattice),
          numbers_(lattice.numbers),
          tiles_(tiles_of(lattice)),
          units_of_batch_(std::min(units_of_batch(tuning), count_of_tiles())),
          indices_(hilbert_order(sites, poll)),
          depth_(depth_of(sites.size())),
          memory_(make_memory(*queue_, lattice, sites.size(), count_of_tiles(), units_of_batch_)),
          sites_(sites.size()),
          shares_(sites.size()),
          moments_(sites.size()) {
        put<std::uint32_t>(memory_.units, tiles_.numbers);
        put<std::uint32_t>(memory_.tile_leaves, tiles_.leaves);
        put<std::uint32_t>(memory_.indices, indices_);
        put<std::uint32_t>(memory_.masses, lattice.masses);
        // The queue reads it until restore() has waited.
        const std::vector<std::uint32_t> exponents(lattice.exponents.begin(),
                                                   lattice.exponents.end());
        put<std::uint32_t>(memory_.exponents, exponents);
        queue_->fill(memory_.hints, NO_OWNER, memory_.hints.words());
        queue_->fill(memory_.report, 0, REPORT_WORDS);
        restore(sites);
    }

    // If an error ends a run, transfers into this object's memory may still be under way.
    ~DeviceRelax() override { queue_->drain(); }
    DeviceRelax(const DeviceRelax&) = delete;
    DeviceRelax& operator=(const DeviceRelax&) = delete;

    std::string device() const override { return queue_->device().name; }
    void watch(std::function<bool()> may_go_on) override {
        may_go_on_ = std::move(may_go_on);
        queue_->watch(may_go_on_);
    }

    // Also accumulates, because the next batch overwrites the tables with the owners of lattice
    // points.
    void assign() override {
        limit_weights();
        assign_leaves(memory_, false);
    }
    void accumulate() override {}

    void move(std::uint32_t way) override {
        launch_over_sites<kernels::move>(kSiteWork, 0, way);
        queue_->wait();
    }

    // A site that ended where there is no importance needs a search. It runs on the host, because
    // there are few such sites and it is done once.
    void rest() override {
        const std::vector<Site> before = along_curve();
        const std::vector<Share> shares = shares_along_curve();
        move(WHOLE_WAY);
        std::vector<Site> moved = along_curve();
        Workers alone(1);
        cpu::SiteTree tree;
        tree.look_at(before, alone);
        const cpu::Scene scene{lattice_, tree, before, indices_, {}, {}};
        const Poll poll = [&] {
            if (may_go_on_ && !may_go_on_()) throw Cancelled();
        };
        std::optional<cpu::PixelTree> pixels;
        for (std::uint32_t i = 0; i < moved.size(); ++i) {
            if (i % kSitesBetweenPolls == 0) poll();
            if (lattice_.stored_below(moved[i]) != 0) continue;
            if (!pixels) pixels.emplace(lattice_, poll);
            moved[i] = cpu::nearest_point(scene, *pixels, i, shares[i].mass != 0, moved[i]);
        }
        put_along_curve(moved);
    }

    std::vector<Site> sites() override { return by_index(along_curve()); }
    std::vector<Share> shares() override { return by_index(shares_along_curve()); }

    void restore(std::span<const Site> sites) override {
        std::vector<Site> sorted(sites.size());
        for (std::size_t i = 0; i < indices_.size(); ++i) sorted[i] = sites[indices_[i]];
        put_along_curve(sorted);
    }

    std::vector<std::uint32_t> owners() override {
        const std::size_t points = std::size_t{numbers_.columns} * numbers_.rows;
        std::vector<std::uint32_t> owners(points);
        Memory telling = memory_;
        telling.owners = queue_->make(points * lacuna::device::kWord);
        queue_->fill(telling.owners, NO_OWNER, points);
        assign_leaves(telling, true);
        get<std::uint32_t>(telling.owners, owners);
        queue_->wait();
        return owners;
    }

private:
    template <typename Value>
    void put(const Buffer& to, std::span<const Value> from) {
        queue_->upload(to, std::as_bytes(from), 0);
    }
    template <typename Value>
    void get(const Buffer& from, std::span<Value> to) {
        queue_->download(from, std::as_writable_bytes(to));
    }

    std::uint32_t units_of_batch(const Tuning& tuning) const {
        if (tuning.units_of_batch != 0) return tuning.units_of_batch;
        return queue_->device().kind == "cpu" ? kUnitsOfProcessor : kUnitsOfGraphics;
    }

    std::uint32_t count_of_tiles() const {
        return static_cast<std::uint32_t>(tiles_.numbers.size());
    }

    // Tiles, or leaves that were late: units that one launch processes in the same way.
    struct Units {
        std::uint32_t first;
        std::uint32_t count;
        std::uint32_t side;  // in leaves
        bool is_telling;
    };

    template <typename Kernel>
    void launch_over_units(const Memory& memory, const Units& units, std::uint32_t items_of_unit,
                           std::uint64_t work) {
        const std::uint32_t items = units.count * items_of_unit;
        const std::uint32_t chunk = queue_->chunk_of(items);
        const std::uint32_t leaf_columns = leaves_in(numbers_.columns);
        lacuna::device::launch<Kernel>(*queue_, memory,
                                       {0, chunk, numbers_, units.first, units.count, units.side,
                                        units.side == 1 ? leaf_columns : tiles_in(numbers_.columns),
                                        leaf_columns, depth_, units.is_telling ? 1u : 0u},
                                       lacuna::device::items_of(items, chunk), work * chunk);
    }

    void find_hints(const Memory& memory, const Units& units) {
        launch_over_units<kernels::find_hints>(memory, units, units.side * units.side, kLeafWork);
    }

    void assign_in_batches(const Memory& memory, const Units& all) {
        for (std::uint32_t first = 0; first < all.count; first += units_of_batch_) {
            const Units batch{first, std::min(units_of_batch_, all.count - first), all.side,
                              all.is_telling};
            launch_over_units<kernels::find_rivals>(memory, batch, 1, kFindWork);
            const std::uint32_t leaves = all.side * all.side;
            launch_over_units<kernels::assign>(memory, batch, leaves, kLeafWork);
            if (all.is_telling)
                launch_over_units<kernels::tell_owners>(memory, batch, leaves * LEAF_SIDE,
                                                        kLeafWork);
        }
    }

    // Returns the number of leaves that must be processed again.
    std::uint32_t wait_for_assign(const Memory& memory) {
        std::array<std::uint32_t, 1> late{};
        get<std::uint32_t>(memory.late_count, late);
        get<std::uint32_t>(memory.report, report_);
        queue_->wait();
        if (report_[FAILURE_WORD] != 0)
            throw lacuna::device::ended_early(queue_->device(), "assign");
        return late.front();
    }

    // Tiles come first. If a tile has too many rivals, its leaves are processed one by one. If a
    // leaf still has too many, its lattice points are.
    void assign_leaves(Memory memory, bool is_telling) {
        queue_->fill(memory.shares, 0, 4 * indices_.size());
        queue_->fill(memory.moments, 0, 4 * indices_.size());
        queue_->fill(memory.late_count, 0, 1);
        const Units tiles{0, count_of_tiles(), TILE_SIDE, is_telling};
        if (!std::exchange(has_hints_, true)) find_hints(memory, tiles);
        assign_in_batches(memory, tiles);
        std::uint32_t late = wait_for_assign(memory);
        if (late == 0) return;
        memory.units = std::exchange(memory.late, queue_->make(late * lacuna::device::kWord));
        queue_->fill(memory.late_count, 0, 1);
        find_hints(memory, {0, late, 1, is_telling});
        assign_in_batches(memory, {0, late, 1, is_telling});
        late = wait_for_assign(memory);
        if (late == 0) return;
        memory.units = memory.late;
        launch_over_units<kernels::assign_crowded>(memory, {0, late, 1, is_telling}, LEAF_SIDE,
                                                   kCrowdedWork);
        wait_for_assign(memory);
    }

    template <typename Kernel>
    void launch_over_sites(std::uint64_t work, std::uint32_t level = 0, std::uint32_t way = 0) {
        const std::uint32_t units = portable::nodes_of_level(numbers_.samples, level);
        const std::uint32_t chunk = queue_->chunk_of(units);
        lacuna::device::launch<Kernel>(
            *queue_, memory_,
            {0, chunk, numbers_, level, begin_of_level(depth_, level), depth_, way},
            lacuna::device::items_of(units, chunk), work * chunk);
    }

    // Builds the tree, limits weights by distances to the nearest sites, and builds the tree again
    // with the new weights.
    void limit_weights() {
        level_sites();
        launch_over_sites<kernels::limit>(kLimitWork, 1);
        std::swap(memory_.sites, memory_.limited);
        level_sites();
    }

    void level_sites() {
        for (std::uint32_t level = 1; level <= depth_; ++level)
            launch_over_sites<kernels::level_sites>(8 * kSiteWork, level);
    }

    std::vector<Site> along_curve() {
        std::vector<Words4> words(indices_.size());
        get<Words4>(memory_.sites, words);
        queue_->wait();
        std::vector<Site> sites(words.size());
        for (std::size_t i = 0; i < words.size(); ++i)
            sites[i] = {words[i][0], words[i][1], portable::join_words(words[i][2], words[i][3])};
        return sites;
    }

    void put_along_curve(const std::vector<Site>& sites) {
        for (std::size_t i = 0; i < sites.size(); ++i) sites_[i] = packed(sites[i]);
        put<Words4>(memory_.sites, sites_);
        queue_->wait();
    }

    std::vector<Share> shares_along_curve() {
        get<Words4>(memory_.shares, shares_);
        get<Words4>(memory_.moments, moments_);
        queue_->wait();
        std::vector<Share> shares(shares_.size());
        for (std::size_t i = 0; i < shares.size(); ++i)
            shares[i] = {shares_[i][0], portable::join_words(shares_[i][2], shares_[i][3]),
                         portable::join_words(moments_[i][0], moments_[i][1]),
                         portable::join_words(moments_[i][2], moments_[i][3])};
        return shares;
    }

    template <typename Value>
    std::vector<Value> by_index(const std::vector<Value>& values) const {
        std::vector<Value> sorted(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) sorted[indices_[i]] = values[i];
        return sorted;
    }

    std::unique_ptr<Queue> queue_;
    std::function<bool()> may_go_on_;
    const Lattice& lattice_;
    const portable::RelaxLattice& numbers_;
    Tiles tiles_;
    std::uint32_t units_of_batch_;
    std::vector<std::uint32_t> indices_;  // of the device's sites, in the order of Hilbert's curve
    std::uint32_t depth_;
    Memory memory_;
    std::vector<Words4> sites_, shares_, moments_;  // for transfers in both directions
    std::array<std::uint32_t, REPORT_WORDS> report_{};
    bool has_hints_ = false;  // found by the first assign, which can be cancelled
};

}  // namespace

std::unique_ptr<RelaxBackend> make_backend(std::unique_ptr<Queue> queue, const Lattice& lattice,
                                           std::span<const Site> sites, const Tuning& tuning,
                                           const Poll& poll) {
    return std::make_unique<DeviceRelax>(std::move(queue), lattice, sites, tuning, poll);
}

}  // namespace lacuna::relaxing::device
