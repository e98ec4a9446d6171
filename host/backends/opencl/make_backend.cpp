// The opencl backend: queues the verbs.
#include "backends/opencl/make_backend.h"

#include <utility>

#include "backends/opencl/cells_backend.h"
#include "backends/opencl/refine.h"
#include "backends/opencl/round_backend.h"
#include "backends/opencl/state.h"

namespace lacuna::opencl {
namespace {

// Chords cut from a line in the time that a draw takes.
constexpr std::uint64_t kChordsPerDraw = 8;

class OpenClBackend : public RoundBackend<State> {
public:
    using RoundBackend::RoundBackend;

private:
    void queue_locate(std::span<const Draw> draws) override {
        State& s = state_;
        s.upload(draws);
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        if (s.has_boxes())
            s.queue.launch_in_slices(s.kernels.locate_in_boxes, items_of(s.draw_count, chunk),
                                     s.draw_count, s.geometry, s.draw_count, chunk, s.boxes.x,
                                     s.boxes.begin, s.draws, s.located);
        for (std::size_t i = 0; i < s.slabs.size() && !s.has_boxes(); ++i) {
            const device::Range range = device::draws_of(s.slabs[i], draws);
            s.queue.launch_in_slices(s.kernels.locate, items_of(range.end - range.begin, chunk),
                                     range.end - range.begin, s.geometry, s.slabs[i].first_line,
                                     range.begin, range.end, chunk, s.spans[i], s.draws, s.located,
                                     s.failure);
        }
        s.sort(s.kernels.sort_columns);
    }

    void queue_admit() override {
        if (state_.plan.is_exact()) queue_screen();
        queue_passes(0);
    }

    void queue_screen() {
        State& s = state_;
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        s.queue.launch_in_slices(s.kernels.screen, items_of(s.draw_count, chunk), s.draw_count,
                                 s.geometry, s.draw_count, chunk, s.candidates, s.grid_x, s.grid_y,
                                 s.fates, s.pending, s.samples);
    }

    void queue_passes(std::uint32_t first_pass) {
        State& s = state_;
        s.begin_passes(first_pass);
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        for (std::uint32_t pass = first_pass; pass < kPasses; ++pass)
            s.queue.launch_in_slices(s.kernels.admit, items_of(s.draw_count, chunk), s.draw_count,
                                     s.geometry, pass, s.draw_count, chunk, s.column_begins,
                                     s.candidates, s.fates, s.pending, s.undecided, s.samples,
                                     s.failure);
    }

    void queue_subtract() override {
        State& s = state_;
        if (s.plan.is_exact()) queue_insert(s);
        s.zero(s.overflow, 1);
        const std::uint32_t columns = s.geometry.columns;
        const std::uint64_t near = std::uint64_t{s.draw_count} * 3 / columns;  // a column, about
        s.queue.launch_in_slices(s.kernels.gather, columns, s.draw_count, s.geometry, kPasses - 1,
                                 s.undecided, s.column_begins, s.near_begins, s.candidates, s.fates,
                                 s.near_counts, s.near, s.failure);
        for (std::size_t i = 0; i < s.slabs.size(); ++i)
            s.queue.launch_in_slices(s.kernels.subtract, s.slabs[i].lines(),
                                     s.slabs[i].lines() * near / kChordsPerDraw, s.geometry,
                                     s.slabs[i].first_line, s.slabs[i].end_line, kPasses - 1,
                                     s.undecided, s.near_begins, s.near_counts, s.near, s.spans[i],
                                     s.span_counts, s.free_lengths, s.overflow, s.failure);
    }

    // Once admission is settled.
    void queue_refine(bool halve) override {
        state_.read_flags();
        while (state_.is_unsettled()) {
            queue_passes(1);
            state_.read_flags();
        }
        opencl::refine(state_, halve);
    }

    bool queue_rest() override {
        if (state_.is_unsettled())
            queue_passes(1);
        else if (state_.host_overflow.front() != 0)
            state_.grow(2 * state_.geometry.capacity);
        else
            return false;
        return true;
    }
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    return make_backend(plan, placement, device::Tuning{});
}

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial) {
    const Found found = choose_device(placement.device);
    const DeviceEntry& entry = found.entry;
    device::refuse_if_too_large(entry.name, plan, entry.memory_bytes, entry.largest_buffer_bytes);
    const auto source = [&] { return plan.is_cells() ? cells_kernel_source() : kernel_source(); };
    const auto program = compiled(found, trial.source.empty() ? source() : trial.source);
    return guarded(entry.name, program->log, [&]() -> std::unique_ptr<Backend> {
        if (plan.is_cells()) return make_cells_backend(program, plan, tuning, trial.launches);
        return std::make_unique<OpenClBackend>(program, plan, tuning, trial.launches);
    });
}

}  // namespace lacuna::opencl
