// The vulkan backend: records the three verbs, and submits and waits once a round.
#include "vulkan/make_backend.h"

#include <algorithm>
#include <utility>

#include "vulkan/memory.h"

namespace lacuna::vulkan {
namespace {

// Lavapipe, like graphics cards, runs neighbouring invocations in lockstep: one draw each.
constexpr std::uint32_t kChunk = 1;

struct Kernels {
    Kernels(Engine& engine, const Programs& programs)
        : locate(engine.make_kernel(programs.locate)),
          sort_columns(engine.make_kernel(programs.sort_columns)),
          admit(engine.make_kernel(programs.admit)),
          gather(engine.make_kernel(programs.gather)),
          subtract(engine.make_kernel(programs.subtract)),
          grow(engine.make_kernel(programs.grow)) {}

    Kernel locate, sort_columns, admit, gather, subtract, grow;
};

class VulkanBackend : public Backend {
public:
    VulkanBackend(std::unique_ptr<Engine> engine, const Plan& plan, const device::Tuning& tuning,
                  const Trial& trial)
        : engine_(std::move(engine)),
          kernels_(*engine_, trial.programs.value_or(embedded_programs())),
          memory_(plan, *engine_, kernels_.grow, largest_slab(tuning)),
          dispatches_(trial.dispatches) {}

    std::string device() const override { return engine_->device().name; }

    void locate(std::span<const Draw> draws) override {
        Memory& m = memory_;
        finish();  // the buffers on the way up may still be in use
        m.upload(draws);
        has_fates_ = is_subtracting_ = false;
        is_recorded_ = true;

        for (std::size_t i = 0; i < m.slabs.size(); ++i) {
            const device::Range range = device::draws_of(m.slabs[i], draws);
            const LocateArguments arguments{0,           m.geometry, m.slabs[i].first_line,
                                            range.begin, range.end,  kChunk};
            engine_->dispatch(kernels_.locate, {m.spans[i], m.draws, m.located}, arguments,
                              range.end - range.begin);
        }
        engine_->barrier();
        engine_->dispatch(kernels_.sort_columns,
                          {m.column_begins, m.located, m.candidates, m.fates},
                          SortColumnsArguments{0, m.geometry, m.draw_count, kChunk}, m.draw_count);
        engine_->barrier();
    }

    void admit() override {
        record_passes(has_fates_ ? 1 : 0);
        is_recorded_ = true;
    }

    void subtract() override {
        record_subtract();
        is_subtracting_ = is_recorded_ = true;
    }

    Round finish_round() override {
        is_recorded_ = true;
        finish();
        device::drop_rejected(memory_.samples_down.as<Sample>().first(memory_.draw_count),
                              samples_);
        return {samples_, memory_.free_lengths_down.as<std::uint32_t>().first(memory_.plan.lines)};
    }

    Snapshot snapshot() override {
        finish();
        return memory_.snapshot();
    }

    void restore(const Snapshot& snapshot) override {
        finish();
        memory_.restore(snapshot);
        has_fates_ = true;
        is_subtracting_ = false;
    }

private:
    std::uint64_t largest_slab(const device::Tuning& tuning) const {
        return tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                              : engine_->device().largest_buffer_bytes;
    }

    // Passes from 1 on take up what earlier ones left undecided; the upload zeroed the counts of
    // all.
    void record_passes(std::uint32_t first_pass) {
        Memory& m = memory_;
        constexpr std::uint64_t kWord = sizeof(std::uint32_t);
        if (first_pass > 0) {
            engine_->fill(m.undecided, 1, kWord);
            engine_->fill(m.undecided, 0, kWord * (kPasses - 1), kWord);
            engine_->barrier();
        }
        for (std::uint32_t pass = first_pass; pass < kPasses; ++pass) {
            engine_->dispatch(
                kernels_.admit, {m.column_begins, m.candidates, m.fates, m.undecided, m.samples},
                AdmitArguments{0, m.geometry, pass, m.draw_count, kChunk}, m.draw_count);
            engine_->barrier();
        }
        has_fates_ = true;
    }

    void record_subtract() {
        Memory& m = memory_;
        engine_->fill(m.overflow, 0, sizeof(std::uint32_t));
        engine_->dispatch(kernels_.gather,
                          {m.undecided, m.column_begins, m.near_begins, m.candidates, m.fates,
                           m.near_counts, m.near},
                          GatherArguments{0, m.geometry, kPasses - 1}, m.geometry.columns);
        engine_->barrier();
        for (std::size_t i = 0; i < m.slabs.size(); ++i) {
            const device::Slab& slab = m.slabs[i];
            engine_->dispatch(
                kernels_.subtract,
                {m.undecided, m.near_begins, m.near_counts, m.near, m.spans[i], m.span_counts,
                 m.free_lengths, m.overflow},
                SubtractArguments{0, m.geometry, slab.first_line, slab.end_line, kPasses - 1},
                slab.lines());
        }
        engine_->barrier();
    }

    // Waits until the verbs are done, with what more it takes: passes, or room.
    void finish() {
        while (is_recorded_) {
            memory_.download();
            engine_->wait();
            const bool unsettled = memory_.undecided_down.as<std::uint32_t>()[kPasses - 1] != 0;
            const bool overflow = memory_.overflow_down.as<std::uint32_t>().front() != 0;
            is_recorded_ = unsettled || overflow;
            if (unsettled)
                record_passes(1);
            else if (overflow)
                memory_.grow();
            if (is_recorded_ && is_subtracting_) record_subtract();
        }
        if (dispatches_ != nullptr) *dispatches_ = engine_->dispatches();
    }

    std::unique_ptr<Engine> engine_;
    Kernels kernels_;
    Memory memory_;
    std::uint64_t* dispatches_;
    std::vector<Sample> samples_;
    bool is_recorded_ = false;  // something waits to be submitted
    bool has_fates_ = false;    // passes have something to take up
    bool is_subtracting_ = false;
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
    return std::make_unique<VulkanBackend>(std::move(engine), plan, tuning, trial);
}

}  // namespace lacuna::vulkan
