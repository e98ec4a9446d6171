// The opencl backend of mode cells: queues the verbs.
#include "backends/opencl/cells_backend.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "backends/device/cells_layout.h"
#include "backends/opencl/cells_state.h"
#include "backends/opencl/round_backend.h"

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

class CellsBackend : public RoundBackend<CellsState> {
public:
    CellsBackend(std::shared_ptr<Program> program, const Plan& plan, const device::Tuning& tuning,
                 std::uint64_t* launches)
        : RoundBackend(std::move(program), plan, launches),
          mean_turns_(mean_turns(plan)),
          slices_(tuning.slices_of_sample) {
        if (slices_ == 0)
            slices_ = state_.queue.serves_chunks() ? 1 : device::slices_of_sample(plan, kMostTurns);
    }

    // Bits are cleared of all that a sample covers: every draw is free of earlier rounds'.
    Round finish_round() override {
        Round round = RoundBackend::finish_round();
        round.survivors = state_.draw_count;
        return round;
    }

private:
    void queue_locate(std::span<const Draw> draws) override {
        CellsState& s = state_;
        s.upload(draws);
        const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
        s.queue.launch_in_slices(s.kernels.locate_in_cells, items_of(s.draw_count, chunk),
                                 s.draw_count, s.geometry, s.words, s.draw_count, chunk, s.bits,
                                 s.draws, s.located, s.failure);
        s.sort(s.kernels.sort_columns);
        s.queue_radii();
    }

    void queue_admit() override { queue_passes(0); }

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

    void queue_subtract() override {
        CellsState& s = state_;
        const std::uint32_t chunk = std::min(s.queue.chunk_of(s.draw_count), kLongestChunk);
        const std::uint32_t items = items_of(s.draw_count, chunk);
        // Fewer where there would be more items than can be counted; then there are enough.
        const std::uint32_t slices = std::min(
            slices_,
            std::max(std::numeric_limits<std::uint32_t>::max() / 2 / std::max(items, 1u), 1u));
        s.queue.launch_in_slices(s.kernels.subtract_in_cells, items * slices,
                                 s.draw_count * mean_turns_ / kTurnsPerDraw, s.geometry, s.words,
                                 s.rows, s.metric, kPasses - 1, s.draw_count, chunk, slices,
                                 s.undecided, s.candidates, s.candidate_radii, s.fates, s.column_of,
                                 s.row_of, s.row_begins, s.pixel_radii, s.pixel_reaches,
                                 s.widest_rows, s.widest, s.bits, s.free_lengths, s.failure);
    }

    void queue_refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }

    bool queue_rest() override {
        if (!state_.is_unsettled()) return false;
        queue_passes(1);
        return true;
    }

    std::uint64_t mean_turns_;
    std::uint32_t slices_;  // of the lines near a sample, each a work item's
};

}  // namespace

std::unique_ptr<Backend> make_cells_backend(std::shared_ptr<Program> program, const Plan& plan,
                                            const device::Tuning& tuning, std::uint64_t* launches) {
    return std::make_unique<CellsBackend>(std::move(program), plan, tuning, launches);
}

}  // namespace lacuna::opencl
