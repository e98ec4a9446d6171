// Relaxation on a device: the lattice's leaves in batches, whose tables one set of buffers holds.
#include "relax/device/make_backend.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "backends/cpu/workers.h"
#include "portable/failure.h"
#include "portable/site_tree.h"
#include "relax/cpu/nearest_own.h"
#include "relax/cpu/site_tree.h"
#include "relax/device/memory.h"
#include "relax/hilbert.h"

namespace lacuna::relaxing::device {
namespace {

namespace kernels = lacuna::device::kernels;
using lacuna::device::Buffer;

// On a processor a batch's tables should stay in its caches; a graphics card wants many items.
constexpr std::size_t kLeavesOfProcessor = 4096;
constexpr std::size_t kLeavesOfGraphics = 65536;

// See Queue::launch: tenths of a microsecond that a leaf takes, or a sample.
constexpr std::uint64_t kFindWork = 20;
constexpr std::uint64_t kRowWork = 2;
constexpr std::uint64_t kSiteWork = 1;

constexpr std::uint32_t kItemsOfLeaf = 8;  // of gather_shares

// As a device keeps them.
using Words2 = std::array<std::uint32_t, 2>;
using Words4 = std::array<std::uint32_t, 4>;

Words4 packed(const Site& site) {
    return {site.x, site.y, portable::to_u32(site.lift), portable::to_u32(site.lift >> 32)};
}

class DeviceRelax : public RelaxBackend {
public:
    DeviceRelax(std::unique_ptr<Queue> queue, const Lattice& lattice, std::span<const Site> sites,
                const Tuning& tuning, const Poll& poll)
        : queue_(std::move(queue)),
          lattice_(lattice),
          numbers_(lattice.numbers),
          leaves_(leaves_of(lattice)),
          leaves_of_batch_(tuning.leaves_of_batch != 0      ? tuning.leaves_of_batch
                           : queue_->device().kind == "cpu" ? kLeavesOfProcessor
                                                            : kLeavesOfGraphics),
          indices_(hilbert_order(sites, poll)),
          depth_(depth_of(sites.size())),
          memory_(make_memory(*queue_, lattice, sites.size(), leaves_.size(), leaves_of_batch_)),
          sites_(sites.size()),
          shares_(sites.size()),
          moments_(sites.size()) {
        put<std::uint32_t>(memory_.leaves, leaves_);
        put<std::uint32_t>(memory_.indices, indices_);
        std::vector<std::uint16_t> masses = lattice.mass;
        masses.resize((masses.size() + 1) / 2 * 2);  // whole words
        put<std::uint16_t>(memory_.masses, masses);
        queue_->fill(memory_.hints, NO_OWNER, leaves_.size());
        queue_->fill(memory_.failure, 0, 1);
        restore(sites);
    }

    // Transfers into this object's memory may be on their way when an error ends a run.
    ~DeviceRelax() override { queue_->drain(); }
    DeviceRelax(const DeviceRelax&) = delete;
    DeviceRelax& operator=(const DeviceRelax&) = delete;

    std::string device() const override { return queue_->device().name; }
    void watch(std::function<bool()> may_go_on) override { queue_->watch(std::move(may_go_on)); }

    // Gathers too: the tables of a batch tell who owns which lattice point, and are lost with the
    // next.
    void own() override { own_leaves(memory_, false); }
    void gather() override {}

    void settle() override {
        queue_->fill(memory_.least, 0, 2);
        launch_over_sites<kernels::settle>(kSiteWork);
        launch_over_sites<kernels::find_least>(kSiteWork);
        level_sites();
        queue_->wait();
    }

    // A search of unbounded length for each sample that ended on white: on the host, as they are
    // few, and this comes once a run.
    void rest() override {
        const std::vector<Site> before = along_curve();
        const std::vector<Share> shares = shares_along_curve();
        settle();
        std::vector<Site> moved = along_curve();
        lacuna::cpu::Workers alone(1);
        cpu::SiteTree tree;
        tree.look_at(before, alone);
        const cpu::Scene scene{lattice_, tree, before, indices_, {}, {}};
        for (std::uint32_t i = 0; i < moved.size(); ++i)
            if (lattice_.mass_under(moved[i]) == 0)
                moved[i] = cpu::nearest_own(scene, i, shares[i].mass != 0, moved[i]);
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
        own_leaves(telling, true);
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

    void own_leaves(const Memory& memory, bool is_telling) {
        queue_->fill(memory.shares, 0, 4 * indices_.size());
        queue_->fill(memory.moments, 0, 4 * indices_.size());
        for (std::size_t first = 0; first < leaves_.size(); first += leaves_of_batch_)
            own_batch(
                memory, static_cast<std::uint32_t>(first),
                static_cast<std::uint32_t>(std::min(leaves_of_batch_, leaves_.size() - first)),
                is_telling);
        get<std::uint32_t>(memory.failure, failure_);
        queue_->wait();
        if (failure_.front() != 0) throw lacuna::device::ended_early(queue_->device(), "own");
    }

    void own_batch(const Memory& memory, std::uint32_t first, std::uint32_t count,
                   bool is_telling) {
        const auto launch = [&]<typename Kernel>(Kernel, std::uint32_t units, std::uint64_t work) {
            const std::uint32_t chunk = queue_->chunk_of(units);
            const portable::LeafArguments arguments{
                0,        chunk,
                numbers_, first,
                count,    (numbers_.columns - 1) / LEAF_SIDE + 1,
                depth_,   is_telling ? 1u : 0u};
            lacuna::device::launch<Kernel>(*queue_, memory, arguments,
                                           lacuna::device::items_of(units, chunk), work * chunk);
        };
        launch(kernels::find_rivals{}, count, kFindWork);
        launch(kernels::own{}, count * LEAF_SIDE, kRowWork);
        launch(kernels::own_crowded{}, count, kRowWork);
        launch(kernels::gather_shares{}, count * kItemsOfLeaf, kRowWork);
    }

    template <typename Kernel>
    void launch_over_sites(std::uint64_t work, std::uint32_t level = 0) {
        const std::uint32_t units = portable::nodes_of_level(numbers_.samples, level);
        const std::uint32_t chunk = queue_->chunk_of(units);
        lacuna::device::launch<Kernel>(*queue_, memory_,
                                       {0, chunk, numbers_, level, begin_of_level(depth_, level)},
                                       lacuna::device::items_of(units, chunk), work * chunk);
    }

    // Takes the least lift off all, and makes the tree anew.
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

    // With lifts as they are: the least of them counts as 0.
    void put_along_curve(const std::vector<Site>& sites) {
        for (std::size_t i = 0; i < sites.size(); ++i) sites_[i] = packed(sites[i]);
        put<Words4>(memory_.sites, sites_);
        queue_->fill(memory_.least, ~0u, 2);
        level_sites();
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
    const Lattice& lattice_;
    const portable::RelaxLattice& numbers_;
    std::vector<std::uint32_t> leaves_;  // with importance
    std::size_t leaves_of_batch_;
    std::vector<std::uint32_t> indices_;  // of the device's sites, which lie along Hilbert's curve
    std::uint32_t depth_;
    Memory memory_;
    std::vector<Words4> sites_, shares_, moments_;  // on their way up or down
    std::array<std::uint32_t, 1> failure_{};
};

}  // namespace

std::unique_ptr<RelaxBackend> make_backend(std::unique_ptr<Queue> queue, const Lattice& lattice,
                                           std::span<const Site> sites, const Tuning& tuning,
                                           const Poll& poll) {
    return std::make_unique<DeviceRelax>(std::move(queue), lattice, sites, tuning, poll);
}

}  // namespace lacuna::relaxing::device
