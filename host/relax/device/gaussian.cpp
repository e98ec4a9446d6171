// The descent of the Gaussian energy on a device: an item serves a sample. In each step the device
// sorts the samples into a grid of cells, whose rows are contiguous.
#include "relax/device/gaussian.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "backends/device/kernels.h"
#include "backends/device/scan.h"
#include "portable/failure.h"
#include "portable/report.h"
#include "relax/device/memory.h"

namespace lacuna::relaxing::device {
namespace {

namespace kernels = lacuna::device::kernels;
using lacuna::device::Buffer;

// Work for Queue::launch, in tenths of a microsecond, of a sample.
constexpr std::uint64_t kSortWork = 1;
constexpr std::uint64_t kDescendWork = 20;

// A sample as the device stores it: x, y and the momentum along both.
using Mover = std::array<std::uint32_t, 4>;

class DeviceGaussian : public GaussianBackend {
public:
    DeviceGaussian(std::unique_ptr<Queue> queue, const GaussianField& field,
                   std::span<const Spot> spots)
        : queue_(std::move(queue)),
          domain_(field.domain),
          cells_(domain_.columns * domain_.rows),
          movers_(spots.size()),
          ids_(spots.size()),
          edges_(field.edge_pulls) {
        edges_.insert(edges_.end(), field.edge_areas.begin(), field.edge_areas.end());
        make_memory(field);
        for (std::size_t i = 0; i < spots.size(); ++i) movers_[i] = {spots[i].x, spots[i].y, 0, 0};
        std::iota(ids_.begin(), ids_.end(), 0u);
        put<Mover>(memory_.movers, movers_);
        put<std::uint32_t>(memory_.mover_ids, ids_);
        put<std::int32_t>(memory_.weights, field.weights);
        put<std::int32_t>(memory_.edges, edges_);
        put<std::uint32_t>(memory_.column_reaches, field.column_reaches);
        queue_->fill(memory_.report, 0, REPORT_WORDS);
        queue_->wait();
    }

    // If an error ends a run, transfers into this object's memory may still be under way.
    ~DeviceGaussian() override { queue_->drain(); }
    DeviceGaussian(const DeviceGaussian&) = delete;
    DeviceGaussian& operator=(const DeviceGaussian&) = delete;

    std::string device() const override { return queue_->device().name; }
    void watch(std::function<bool()> may_go_on) override { queue_->watch(std::move(may_go_on)); }

    void descend(std::uint32_t pace) override {
        queue_->fill(memory_.counts, 0, cells_ + 1);
        launch<kernels::find_cells>(pace, kSortWork);
        lacuna::device::scan(*queue_, memory_, cells_ + 1);
        launch<kernels::sort_into_cells>(pace, kSortWork);
        launch<kernels::descend>(pace, kDescendWork);
        queue_->download(memory_.report, std::as_writable_bytes(std::span(report_)));
        queue_->wait();
        if (report_[FAILURE_WORD] != 0)
            throw lacuna::device::ended_early(queue_->device(), "descend");
    }

    std::vector<Spot> spots() override {
        queue_->download(memory_.movers, std::as_writable_bytes(std::span(movers_)));
        queue_->download(memory_.mover_ids, std::as_writable_bytes(std::span(ids_)));
        queue_->wait();
        std::vector<Spot> spots(movers_.size());
        for (std::size_t i = 0; i < spots.size(); ++i)
            spots[ids_[i]] = {movers_[i][0], movers_[i][1]};
        return spots;
    }

private:
    void make_memory(const GaussianField& field) {
        const std::uint64_t samples = movers_.size();
        const std::uint64_t blocks = lacuna::device::blocks_of_scan(cells_ + std::uint64_t{1});
        const std::array needs{Need{&Memory::movers, 4 * samples},
                               Need{&Memory::sorted_movers, 4 * samples},
                               Need{&Memory::mover_ids, samples},
                               Need{&Memory::sorted_ids, samples},
                               Need{&Memory::ranks, samples},
                               Need{&Memory::counts, cells_ + std::uint64_t{1}},
                               Need{&Memory::sums, blocks},
                               Need{&Memory::tops, blocks},
                               Need{&Memory::weights, field.weights.size()},
                               Need{&Memory::edges, edges_.size()},
                               Need{&Memory::column_reaches, field.column_reaches.size()},
                               Need{&Memory::report, REPORT_WORDS}};
        memory_ = make_buffers(*queue_, needs);
    }

    template <typename Value>
    void put(const Buffer& to, std::span<const Value> from) {
        queue_->upload(to, std::as_bytes(from), 0);
    }

    // An item serves one sample where these are crowded: see refuse_crowds in relax/gaussian.cpp.
    template <typename Kernel>
    void launch(std::uint32_t pace, std::uint64_t work) {
        lacuna::device::launch<Kernel>(
            *queue_, memory_,
            {0, 1, domain_, pace, lacuna::device::block_bits_of_scan(cells_ + std::uint64_t{1})},
            domain_.samples, work);
    }

    std::unique_ptr<Queue> queue_;
    portable::GaussianDomain domain_;
    std::uint32_t cells_;
    Memory memory_;
    std::vector<Mover> movers_;       // for transfers in both directions
    std::vector<std::uint32_t> ids_;  // of movers_
    std::vector<std::int32_t> edges_;
    std::array<std::uint32_t, REPORT_WORDS> report_{};
};

}  // namespace

std::unique_ptr<GaussianBackend> make_gaussian_backend(std::unique_ptr<Queue> queue,
                                                       const GaussianField& field,
                                                       std::span<const Spot> spots) {
    return std::make_unique<DeviceGaussian>(std::move(queue), field, spots);
}

}  // namespace lacuna::relaxing::device
