// The opencl backend: queues the three verbs and waits for each.
#include "opencl/make_backend.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "columns.h"
#include "opencl/state.h"

namespace lacuna::opencl {
namespace {

class OpenClBackend : public Backend {
public:
    OpenClBackend(std::shared_ptr<Program> program, const Plan& plan, const device::Tuning& tuning,
                  std::uint64_t* launches)
        : name_(program->entry.name), state_(std::move(program), plan, tuning, launches) {}

    // Transfers into this object's memory may be on their way when an error ends a run.
    ~OpenClBackend() override {
        try {
            state_.queue.finish();
        } catch (const cl::Error&) {  // of the run, and told by it
        }
    }
    OpenClBackend(const OpenClBackend&) = delete;
    OpenClBackend& operator=(const OpenClBackend&) = delete;

    std::string device() const override { return name_; }

    void locate(std::span<const Draw> draws) override {
        guard([&] { queue_locate(draws); });
        finish_verb();
    }
    void admit() override {
        guard([&] { queue_passes(settling_ ? 1 : 0); });
        finish_verb();
    }
    void subtract() override {
        guard([&] { queue_subtract(); });
        finish_verb();
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
            settling_ = true;
            subtracting_ = false;
        });
    }

private:
    template <typename Work>
    std::invoke_result_t<Work> guard(Work work) {
        return guarded(name_, state_.program->log, work);
    }

    // An observer can then tell the verbs' times apart; it costs some 30 us a verb.
    void finish_verb() {
        guard([&] { state_.queue.finish(); });
    }

    void queue_locate(std::span<const Draw> draws) {
        State& s = state_;
        const auto count = static_cast<std::uint32_t>(draws.size());
        find_column_begins(s.plan, s.geometry.columns, draws, s.host_column_begins);
        s.begin_round(count);
        s.queue.write(s.draws, draws);
        settling_ = false;
        subtracting_ = false;

        const std::uint32_t chunk = s.queue.chunk_of(count);
        for (std::size_t i = 0; i < s.slabs.size(); ++i) {
            const device::Range range = device::draws_of(s.slabs[i], draws);
            s.queue.launch(s.kernels.locate, items(range.end - range.begin, chunk), s.geometry,
                           s.slabs[i].first_line, range.begin, range.end, chunk, s.spans[i],
                           s.draws, s.located);
        }
        s.queue.launch(s.kernels.sort_columns, items(count, chunk), s.geometry, count, chunk,
                       s.column_begins, s.located, s.candidates, s.fates);
    }

    // Passes from 1 on take up what earlier ones left undecided.
    void queue_passes(std::uint32_t first_pass) {
        State& s = state_;
        const std::array<std::uint32_t, kPasses> unsettled = {1};
        if (first_pass == 1) s.queue.write<std::uint32_t>(s.undecided, unsettled);
        settling_ = true;

        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        for (std::uint32_t pass = first_pass; pass < kPasses; ++pass)
            s.queue.launch(s.kernels.admit, items(s.draw_count, chunk), s.geometry, pass,
                           s.draw_count, chunk, s.column_begins, s.candidates, s.fates, s.undecided,
                           s.samples);
    }

    void queue_subtract() {
        State& s = state_;
        subtracting_ = true;
        s.queue.zero(s.overflow, 1);
        s.queue.launch(s.kernels.gather, s.geometry.columns, s.geometry, kPasses - 1, s.undecided,
                       s.column_begins, s.near_begins, s.candidates, s.fates, s.near_counts,
                       s.near);
        for (std::size_t i = 0; i < s.slabs.size(); ++i)
            s.queue.launch(s.kernels.subtract, s.slabs[i].lines(), s.geometry,
                           s.slabs[i].first_line, s.slabs[i].end_line, kPasses - 1, s.undecided,
                           s.near_begins, s.near_counts, s.near, s.spans[i], s.span_counts,
                           s.free_lengths, s.overflow);
    }

    // Waits until the round is done, with what more it takes: passes, or room.
    Round wait() {
        State& s = state_;
        by_order_.resize(s.draw_count);
        free_lengths_.resize(s.plan.lines);
        while (true) {
            s.queue.start_read<std::uint32_t>(s.undecided, undecided_);
            s.queue.start_read<std::uint32_t>(s.overflow, overflow_);
            s.queue.start_read<std::uint32_t>(s.free_lengths, free_lengths_);
            s.queue.start_read<Sample>(s.samples, by_order_);
            s.queue.finish();
            if (undecided_.back() != 0)
                queue_passes(1);
            else if (overflow_.front() != 0)
                s.grow(2 * s.geometry.capacity);
            else
                break;
            if (subtracting_) queue_subtract();
        }
        device::drop_rejected(by_order_, samples_);
        return {samples_, free_lengths_};
    }

    static std::uint32_t items(std::uint32_t draws, std::uint32_t chunk) {
        return static_cast<std::uint32_t>((std::uint64_t{draws} + chunk - 1) / chunk);
    }

    std::string name_;
    // Reads end here: before the state, whose queue writes to it.
    std::vector<Sample> by_order_;
    std::vector<std::uint32_t> free_lengths_;
    std::array<std::uint32_t, kPasses> undecided_{};
    std::array<std::uint32_t, 1> overflow_{};
    std::vector<Sample> samples_;
    State state_;
    bool settling_ = false;     // fates are there to be taken up
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
    const auto program = compiled(found, trial.source.empty() ? kernel_source() : trial.source);
    return guarded(entry.name, program->log, [&] {
        return std::make_unique<OpenClBackend>(program, plan, tuning, trial.launches);
    });
}

}  // namespace lacuna::opencl
