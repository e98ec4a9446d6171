// The opencl backend: queues the verbs and waits for each.
#include "opencl/make_backend.h"

#include <functional>
#include <type_traits>
#include <utility>

#include "opencl/cells_backend.h"
#include "opencl/refine.h"
#include "opencl/state.h"

namespace lacuna::opencl {
namespace {

// Chords cut from a line in the time that a draw takes.
constexpr std::uint64_t kChordsPerDraw = 8;

class OpenClBackend : public Backend {
public:
    OpenClBackend(std::shared_ptr<Program> program, const Plan& plan, const device::Tuning& tuning,
                  std::uint64_t* launches)
        : name_(program->entry.name), state_(std::move(program), plan, tuning, launches) {}

    // Transfers into this object's memory may be on their way when an error ends a run.
    ~OpenClBackend() override {
        try {
            state_.queue.drain();
        } catch (const cl::Error&) {  // of the run, and told by it
        }
    }
    OpenClBackend(const OpenClBackend&) = delete;
    OpenClBackend& operator=(const OpenClBackend&) = delete;

    std::string device() const override { return name_; }
    void watch(std::function<bool()> may_go_on) override {
        state_.queue.watch(std::move(may_go_on));
    }

    // Each verb waits, so that an observer can tell their times apart; it costs some 30 us a verb.
    void locate(std::span<const Draw> draws) override {
        guard([&] {
            queue_locate(draws);
            state_.queue.finish();
        });
    }
    void admit() override {
        guard([&] {
            if (state_.plan.exact) queue_screen();
            queue_passes(0);
            state_.queue.finish();
        });
    }
    void subtract() override {
        guard([&] {
            subtracting_ = true;
            queue_subtract();
            state_.queue.finish();
        });
    }
    void refine(bool halve) override {
        guard([&] {
            settle();
            opencl::refine(state_, halve);
            state_.queue.finish();
        });
    }
    Round finish_round() override {
        return guard([&] { return wait(); });
    }

    Snapshot snapshot() override {
        return guard([&] {
            wait();
            return state_.snapshot();
        });
    }
    void restore(const Snapshot& snapshot) override {
        guard([&] {
            state_.restore(snapshot);
            subtracting_ = false;
        });
    }

private:
    template <typename Work>
    std::invoke_result_t<Work> guard(Work work) {
        return guarded(name_, state_.program->log, work);
    }

    void queue_locate(std::span<const Draw> draws) {
        State& s = state_;
        s.upload(draws);
        subtracting_ = false;
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

    void queue_screen() {
        State& s = state_;
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        s.queue.launch_in_slices(s.kernels.screen, items_of(s.draw_count, chunk), s.draw_count,
                                 s.geometry, s.draw_count, chunk, s.candidates, s.cell_x, s.cell_y,
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

    void queue_subtract() {
        State& s = state_;
        if (s.plan.exact) queue_insert(s);
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

    // Waits until admission is settled.
    void settle() {
        state_.read_flags();
        while (state_.is_unsettled()) {
            queue_passes(1);
            state_.read_flags();
        }
    }

    // Waits until the round is done, with what more it takes: passes, or room.
    Round wait() {
        State& s = state_;
        by_order_.resize(s.draw_count);
        free_lengths_.resize(s.place_count);
        while (true) {
            s.queue.start_read<std::uint32_t>(s.free_lengths, free_lengths_);
            s.queue.start_read<Sample>(s.samples, by_order_);
            s.read_flags();
            if (s.is_unsettled())
                queue_passes(1);
            else if (s.host_overflow.front() != 0)
                s.grow(2 * s.geometry.capacity);
            else
                break;
            if (subtracting_) queue_subtract();
        }
        const std::uint64_t survivors = device::take_admitted(by_order_, samples_);
        return {samples_, survivors, free_lengths_, s.place_width()};
    }

    std::string name_;
    // Reads end here: before the state, whose queue writes to it.
    std::vector<Sample> by_order_;
    std::vector<std::uint32_t> free_lengths_;
    State state_;
    std::vector<Sample> samples_;
    bool subtracting_ = false;  // the round's subtraction has been asked for
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
    const auto source = [&] { return plan.radii ? cells_kernel_source() : kernel_source(); };
    const auto program = compiled(found, trial.source.empty() ? source() : trial.source);
    return guarded(entry.name, program->log, [&]() -> std::unique_ptr<Backend> {
        if (plan.radii) return make_cells_backend(program, plan, tuning, trial.launches);
        return std::make_unique<OpenClBackend>(program, plan, tuning, trial.launches);
    });
}

}  // namespace lacuna::opencl
