// The vulkan backend: records a verb, submits it and waits.
#include "backends/vulkan/make_backend.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "backends/columns.h"
#include "backends/vulkan/boxes.h"
#include "backends/vulkan/cells_backend.h"
#include "backends/vulkan/kernels.h"
#include "backends/vulkan/memory.h"
#include "backends/vulkan/transfer.h"

namespace lacuna::vulkan {
namespace {

// Of draws. But for served_together lavapipe, too, runs neighbouring invocations in lockstep.
constexpr std::uint32_t kChunk = 1;

// See Engine::dispatch.
constexpr std::uint32_t kLocateWork = 4;
constexpr std::uint32_t kAdmitWork = 6;
constexpr std::uint32_t kCutWork = 1;  // a line and sample near it

class VulkanBackend : public Backend {
public:
    VulkanBackend(std::unique_ptr<Engine> engine, const Plan& plan, const device::Tuning& tuning,
                  const Trial& trial)
        : engine_(std::move(engine)),
          kernels_(*engine_, trial.programs.value_or(embedded_programs()), plan.is_exact()),
          memory_(plan, *engine_, kernels_.grow, largest_slab(tuning)),
          first_lines_(first_lines(plan, memory_.geometry.columns)),
          served_together_(served_together(*engine_)),
          dispatches_(trial.dispatches) {
        if (plan.is_exact()) boxes_.emplace(plan, *engine_, kernels_);
    }

    std::string device() const override { return engine_->device().name; }

    void watch(std::function<bool()> may_go_on) override { engine_->watch(std::move(may_go_on)); }

    // Each verb waits, so that an observer can tell their times apart.
    void locate(std::span<const Draw> draws) override {
        Memory& m = memory_;
        finish();  // the buffers on the way up may still be in use
        m.upload(draws, has_boxes() ? boxes_->place_begins() : first_lines_);
        has_fates_ = false;
        ends_with_ = End::none;
        is_recorded_ = true;
        if (has_boxes())
            boxes_->locate(m, kChunk);
        else
            record_walk(draws);
        engine_->barrier();
        m.sort(kernels_.sort_columns);
        engine_->wait();
    }

    void admit() override {
        if (boxes_) boxes_->screen(memory_, kChunk);
        record_passes(has_fates_ ? 1 : 0);
        is_recorded_ = true;
        engine_->wait();
    }

    void subtract() override {
        ends_with_ = End::subtract;
        record_end();
        engine_->wait();
    }

    void refine(bool halve) override {
        if (!has_boxes()) unfold();
        ends_with_ = End::refine;
        halves_ = halve;
        record_end();
        engine_->wait();
    }

    Round finish_round() override {
        is_recorded_ = true;
        finish();
        const std::uint64_t survivors = device::take_admitted(
            memory_.samples_down.as<Sample>().first(memory_.draw_count), samples_);
        if (has_boxes()) return {samples_, survivors, boxes_->lengths(), boxes_->width()};
        const Plan& plan = memory_.plan;
        return {samples_, survivors,
                memory_.free_lengths_down.as<std::uint32_t>().first(plan.lines), plan.strip_width};
    }

    Snapshot snapshot() override {
        finish();
        Snapshot snapshot;
        memory_.snapshot_round(snapshot);
        if (!has_boxes()) memory_.snapshot_spans(snapshot);
        if (boxes_) boxes_->snapshot(snapshot);
        return snapshot;
    }

    void restore(const Snapshot& snapshot) override {
        finish();
        if (boxes_) boxes_->restore(snapshot);
        if (has_boxes())
            memory_.drop_spans();
        else
            memory_.restore_spans(snapshot);
        memory_.begin_restored_round(snapshot);
        memory_.sort(kernels_.sort_columns);  // for the buckets' sake
        memory_.restore_fates(snapshot);
        has_fates_ = true;
        ends_with_ = End::none;
    }

private:
    enum class End { none, subtract, refine };  // of the round

    bool has_boxes() const { return boxes_ && boxes_->are_places(); }

    std::uint64_t largest_slab(const device::Tuning& tuning) const {
        return tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                              : engine_->device().largest_buffer_bytes;
    }

    // How many invocations serve so many draws.
    std::uint32_t items_of(std::uint32_t draws) const {
        return (draws + served_together_ - 1) / served_together_;
    }

    void record_walk(std::span<const Draw> draws) {
        Memory& m = memory_;
        const std::uint32_t chunk = served_together_;
        for (std::size_t i = 0; i < m.slabs.size(); ++i) {
            const device::Range range = device::draws_of(m.slabs[i], draws);
            const LocateArguments arguments{0,           m.geometry, m.slabs[i].first_line,
                                            range.begin, range.end,  chunk};
            engine_->dispatch(kernels_.locate, {m.spans[i], m.draws, m.located, m.failure},
                              arguments, items_of(range.end - range.begin), kLocateWork * chunk);
        }
    }

    // Passes from 1 on take up what earlier ones left undecided; the upload zeroed the counts of
    // all.
    void record_passes(std::uint32_t first_pass) {
        Memory& m = memory_;
        if (first_pass > 0) m.begin_more_passes();
        for (std::uint32_t pass = first_pass; pass < kPasses; ++pass) {
            engine_->dispatch(kernels_.admit,
                              {m.column_begins, m.buckets, m.candidates, m.fates, m.undecided,
                               m.samples, m.failure},
                              AdmitArguments{0, m.geometry, pass, m.draw_count, served_together_},
                              items_of(m.draw_count),
                              (pass == 0 ? kAdmitWork : 1) * served_together_);
            engine_->barrier();
        }
        has_fates_ = true;
    }

    void record_subtract() {
        Memory& m = memory_;
        if (boxes_) boxes_->insert(m);
        const std::uint32_t near = 3 * m.draws_per_column();
        engine_->fill(m.overflow, 0, kWord);
        engine_->dispatch(kernels_.gather,
                          {m.undecided, m.column_begins, m.near_begins, m.candidates, m.fates,
                           m.near_counts, m.near, m.failure},
                          GatherArguments{0, m.geometry, kPasses - 1}, m.geometry.columns, near);
        engine_->barrier();
        for (std::size_t i = 0; i < m.slabs.size(); ++i) {
            const device::Slab& slab = m.slabs[i];
            engine_->dispatch(
                kernels_.subtract,
                {m.undecided, m.near_begins, m.near_counts, m.near, m.spans[i], m.span_counts,
                 m.free_lengths, m.overflow, m.failure},
                SubtractArguments{0, m.geometry, slab.first_line, slab.end_line, kPasses - 1},
                slab.lines(), kCutWork * near);
        }
        engine_->barrier();
    }

    void unfold() {
        boxes_->count_spans(memory_);
        is_recorded_ = true;
        finish();
        boxes_->unfold(memory_);
        memory_.drop_spans();
    }

    void record_end() {
        is_recorded_ = true;
        if (ends_with_ == End::subtract) record_subtract();
        if (ends_with_ != End::refine) return;
        boxes_->insert(memory_);
        boxes_->refine(memory_, halves_);
    }

    void download() {
        memory_.download();
        if (boxes_) boxes_->download();
        engine_->wait();
        if (dispatches_ != nullptr) *dispatches_ = engine_->dispatches();
        memory_.throw_if_failed();
    }

    // Waits until the verbs are done, with what more it takes: passes, or room.
    void finish() {
        while (is_recorded_) {
            download();
            is_recorded_ = false;
            if (memory_.is_unsettled()) {
                record_passes(1);
                is_recorded_ = true;
                record_end();
            } else if (memory_.overflow_down.as<std::uint32_t>().front() != 0) {
                memory_.grow();
                record_end();
            } else if (ends_with_ == End::refine && boxes_->lacks_room()) {
                boxes_->make_room_and_keep(memory_);
                is_recorded_ = true;
            }
        }
        if (ends_with_ == End::refine) boxes_->accept();
        ends_with_ = End::none;
    }

    std::unique_ptr<Engine> engine_;
    Kernels kernels_;
    Memory memory_;
    std::optional<Boxes> boxes_;  // in exact
    std::vector<std::uint32_t> first_lines_;
    std::uint32_t served_together_;
    std::uint64_t* dispatches_;
    std::vector<Sample> samples_;
    bool is_recorded_ = false;  // something whose outcome is not known yet
    bool has_fates_ = false;    // passes have something to take up
    End ends_with_ = End::none;
    bool halves_ = false;
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    return make_backend(plan, placement, device::Tuning{});
}

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial) {
    auto engine = std::make_unique<Engine>(placement.device, trial.validation);
    const DeviceEntry& device = engine->device();
    device::refuse_if_too_large(device.name, plan, device.memory_bytes,
                                device.largest_buffer_bytes);
    if (plan.is_cells()) return make_cells_backend(std::move(engine), plan, trial);
    return std::make_unique<VulkanBackend>(std::move(engine), plan, tuning, trial);
}

}  // namespace lacuna::vulkan
