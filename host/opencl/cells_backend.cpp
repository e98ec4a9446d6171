// The opencl backend of mode cells: queues the verbs and waits for each.
#include "opencl/cells_backend.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "device/cells_layout.h"
#include "device/layout.h"
#include "opencl/cells_state.h"

namespace lacuna::opencl {
namespace {

// Turns of subtract in the time that a draw takes.
constexpr std::uint64_t kTurnsPerDraw = 16;
// Of one work item on a graphics card, at most: a millisecond or so.
constexpr std::uint64_t kMostTurns = 16384;
// Of subtract; a sample is much more work than a draw.
constexpr std::uint32_t kLongestChunk = 64;

// Of subtract for a sample anywhere, on average.
std::uint64_t mean_turns(const Plan& plan) {
    std::uint64_t sum = 0;
    for (const std::uint32_t reach : plan.radii->reaches)
        sum += reach != 0 ? device::turns_of_sample(plan, reach) : 0;
    return sum / plan.radii->reaches.size();
}

class CellsBackend : public Backend {
public:
    CellsBackend(std::shared_ptr<Program> program, const Plan& plan, const device::Tuning& tuning,
                 std::uint64_t* launches)
        : name_(program->entry.name),
          state_(std::move(program), plan, launches),
          mean_turns_(mean_turns(plan)),
          slices_(tuning.slices_of_sample) {
        if (slices_ == 0)
            slices_ = state_.queue.serves_chunks() ? 1 : device::slices_of_sample(plan, kMostTurns);
    }

    // Transfers into this object's memory may be on their way when an error ends a run.
    ~CellsBackend() override {
        try {
            state_.queue.drain();
        } catch (const cl::Error&) {  // of the run, and told by it
        }
    }
    CellsBackend(const CellsBackend&) = delete;
    CellsBackend& operator=(const CellsBackend&) = delete;

    std::string device() const override { return name_; }
    void watch(std::function<bool()> may_go_on) override {
        state_.queue.watch(std::move(may_go_on));
    }

    // Each verb waits, so that an observer can tell their times apart.
    void locate(std::span<const Draw> draws) override {
        guard([&] {
            queue_locate(draws);
            state_.queue.finish();
        });
    }
    void admit() override {
        guard([&] {
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
    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }
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
        CellsState& s = state_;
        s.upload(draws);
        subtracting_ = false;
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        s.queue.launch_in_slices(s.kernels.locate_in_cells, items_of(s.draw_count, chunk),
                                 s.draw_count, s.geometry, s.words, s.draw_count, chunk, s.bits,
                                 s.draws, s.located, s.failure);
        s.sort(s.kernels.sort_columns);
        s.queue_radii();
    }

    void queue_passes(std::uint32_t first_pass) {
        CellsState& s = state_;
        s.begin_passes(first_pass);
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        for (std::uint32_t pass = first_pass; pass < kPasses; ++pass)
            s.queue.launch_in_slices(s.kernels.admit_in_cells, items_of(s.draw_count, chunk),
                                     s.draw_count, s.geometry, s.rows, s.metric, pass, s.draw_count,
                                     chunk, s.column_begins, s.candidates, s.candidate_radii,
                                     s.column_of, s.row_of, s.pixel_reaches, s.fates, s.pending,
                                     s.undecided, s.samples, s.failure);
    }

    void queue_subtract() {
        CellsState& s = state_;
        const std::uint32_t chunk = std::min(s.queue.chunk_of(s.draw_count), kLongestChunk);
        const std::uint32_t items = items_of(s.draw_count, chunk);
        // Fewer where there would be more items than can be counted; then there are enough.
        const std::uint32_t slices = std::min(
            slices_,
            std::max(std::numeric_limits<std::uint32_t>::max() / 2 / std::max(items, 1u), 1u));
        s.queue.launch_in_slices(
            s.kernels.subtract_in_cells, items * slices, s.draw_count * mean_turns_ / kTurnsPerDraw,
            s.geometry, s.words, s.rows, s.metric, kPasses - 1, s.draw_count, chunk, slices,
            s.undecided, s.candidates, s.candidate_radii, s.fates, s.column_of, s.row_of,
            s.row_begins, s.pixel_radii, s.pixel_reaches, s.bits, s.free_lengths, s.failure);
    }

    // Waits until the round is done, with what more passes it takes.
    Round wait() {
        CellsState& s = state_;
        by_order_.resize(s.draw_count);
        free_lengths_.resize(s.plan.lines);
        while (true) {
            s.queue.start_read<std::uint32_t>(s.free_lengths, free_lengths_);
            s.queue.start_read<Sample>(s.samples, by_order_);
            s.read_flags();
            if (!s.is_unsettled()) break;
            queue_passes(1);
            if (subtracting_) queue_subtract();
        }
        device::take_admitted(by_order_, samples_);
        // Bits are cleared of all that a sample covers: every draw is free of earlier rounds'.
        return {samples_, s.draw_count, free_lengths_, 1};
    }

    std::string name_;
    // Reads end here: before the state, whose queue writes to it.
    std::vector<Sample> by_order_;
    std::vector<std::uint32_t> free_lengths_;
    CellsState state_;
    std::vector<Sample> samples_;
    std::uint64_t mean_turns_;
    std::uint32_t slices_;      // of the lines near a sample, each a work item's
    bool subtracting_ = false;  // the round's subtraction has been asked for
};

}  // namespace

std::unique_ptr<Backend> make_cells_backend(std::shared_ptr<Program> program, const Plan& plan,
                                            const device::Tuning& tuning, std::uint64_t* launches) {
    return std::make_unique<CellsBackend>(std::move(program), plan, tuning, launches);
}

}  // namespace lacuna::opencl
