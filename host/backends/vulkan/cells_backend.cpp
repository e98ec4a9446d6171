// The vulkan backend of mode cells: records a verb, submits it and waits.
#include "backends/vulkan/cells_backend.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/device/cells_layout.h"
#include "backends/device/layout.h"
#include "backends/vulkan/cells_state.h"
#include "backends/vulkan/kernels.h"
#include "backends/vulkan/transfer.h"

namespace lacuna::vulkan {
namespace {

// Turns of all its loops that an invocation is given work for: lavapipe grants 65,535.
constexpr std::uint64_t kMostTurns = 1u << 14;
// Of subtract, as cells_layout.h counts them. For each it takes up to 9: lavapipe goes through the
// roots' loops also where the last root is used again, runs end with their words, and where a reach
// is longer than a torus, the chord is seen from three heights. And a look takes up to 64 a line.
constexpr std::uint64_t kMostTurnsOfSlice = kMostTurns / 4;
// Neighbouring invocations, which lavapipe runs in lockstep, serve neighbouring lines.
constexpr std::uint32_t kLeastSlices = 16;

// See Engine::dispatch.
constexpr std::uint32_t kWordsPerWork = 32;
constexpr std::uint32_t kAdmitWork = 6;
constexpr std::uint64_t kTurnsPerWork = 8;

// Into how many slices the lines near a sample are cut that reaches so far.
std::uint32_t slices_of(const Plan& plan, std::uint32_t reach) {
    const std::uint64_t lines_of_slice =
        std::max<std::uint64_t>(kMostTurnsOfSlice / device::turns_of_line(plan, reach), 1);
    const std::uint64_t lines = std::min(2 * std::uint64_t{reach} + 1, std::uint64_t{plan.lines});
    return std::max(kLeastSlices,
                    static_cast<std::uint32_t>((lines + lines_of_slice - 1) / lines_of_slice));
}

// The farthest reach for which the least number of slices will do.
std::uint32_t short_reach(const Plan& plan, std::uint32_t widest) {
    std::uint32_t reach = 1;
    while (reach < widest && slices_of(plan, reach + 1) == kLeastSlices) ++reach;
    return reach;
}

// Of a slice.
std::uint32_t subtract_work(const Plan& plan, std::uint32_t reach, std::uint32_t slices) {
    const std::uint64_t turns = device::turns_of_sample(plan, reach) / slices;
    return static_cast<std::uint32_t>(turns / kTurnsPerWork) + 1;
}

// Of a sample anywhere: samples are as dense as their reaches are short, squared.
std::uint32_t mean_reach(const Plan& plan) {
    double density = 0;
    double pixels = 0;
    for (const std::uint32_t reach : plan.radii->reaches) {
        if (reach == 0) continue;
        density += 1 / (static_cast<double>(reach) * reach);
        ++pixels;
    }
    return static_cast<std::uint32_t>(std::sqrt(pixels / density));
}

// What the widest reach spans of the lattice.
struct Widest {
    explicit Widest(const Plan& plan) {
        const std::vector<std::uint32_t>& reaches = plan.radii->reaches;
        reach = *std::max_element(reaches.begin(), reaches.end());
        const double side = 2.0 * reach + 1;
        share_of_lines = std::min(side / plan.lines, 1.0);
        share = share_of_lines * std::min(side / plan.height, 1.0);
    }
    std::uint32_t reach;
    double share_of_lines;
    double share;
};

class CellsBackend : public Backend {
public:
    CellsBackend(std::unique_ptr<Engine> engine, const Plan& plan, const Trial& trial)
        : engine_(std::move(engine)),
          kernels_(*engine_, trial.programs.value_or(embedded_programs())),
          state_(plan, *engine_),
          widest_(plan),
          short_reach_(short_reach(plan, widest_.reach)),
          mean_reach_(std::min(mean_reach(plan), short_reach_)),
          served_together_(served_together(*engine_)),
          dispatches_(trial.dispatches) {}

    std::string device() const override { return engine_->device().name; }

    void watch(std::function<bool()> may_go_on) override { engine_->watch(std::move(may_go_on)); }

    // Each verb waits, so that an observer can tell their times apart.
    void locate(std::span<const Draw> draws) override {
        finish();  // the buffers on the way up may still be in use
        state_.upload(draws);
        has_fates_ = false;
        subtracts_ = false;
        is_recorded_ = true;
        const std::uint32_t chunk = chunk_of(state_.words);  // a draw may walk the whole line
        engine_->dispatch(
            kernels_.locate, {state_.bits, state_.draws, state_.located, state_.failure},
            LocateInCellsArguments{0, state_.geometry, state_.words, state_.draw_count, chunk},
            items_of(chunk), chunk * (state_.words / kWordsPerWork + 1));
        engine_->barrier();
        state_.sort(kernels_.sort_columns);
        record_radii();
        engine_->wait();
    }

    void admit() override {
        record_passes(has_fates_ ? 1 : 0);
        is_recorded_ = true;
        engine_->wait();
    }

    void subtract() override {
        subtracts_ = true;
        is_recorded_ = true;
        record_subtract();
        engine_->wait();
    }

    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }

    Round finish_round() override {
        is_recorded_ = true;
        finish();
        device::take_admitted(state_.samples_down.as<Sample>().first(state_.draw_count), samples_);
        // A bit is cleared as soon as it is blocked: no draw is covered by an earlier round.
        return {samples_, state_.draw_count,
                state_.free_lengths_down.as<std::uint32_t>().first(state_.plan.lines), 1};
    }

    Snapshot snapshot() override {
        finish();
        return state_.snapshot();
    }

    void restore(const Snapshot& snapshot) override {
        finish();
        state_.begin_restored(snapshot);
        state_.sort(kernels_.sort_columns);  // for the buckets' sake
        record_radii();
        state_.restore_fates(snapshot);
        has_fates_ = true;
        subtracts_ = false;
    }

private:
    std::uint32_t rows() const { return state_.plan.radii->rows; }
    std::uint32_t metric() const { return static_cast<std::uint32_t>(state_.plan.metric); }

    // Draws that one invocation serves, of so many turns each.
    std::uint32_t chunk_of(std::uint64_t turns) const {
        return static_cast<std::uint32_t>(
            std::clamp<std::uint64_t>(kMostTurns / turns, 1, served_together_));
    }
    std::uint32_t items_of(std::uint32_t chunk) const {
        return (state_.draw_count + chunk - 1) / chunk;
    }

    void record_radii() {
        engine_->dispatch(kernels_.look_up_radii,
                          {state_.candidates, state_.column_of, state_.row_of, state_.pixel_radii,
                           state_.candidate_radii},
                          LookUpRadiiArguments{0, rows(), state_.draw_count}, state_.draw_count);
        engine_->barrier();
    }

    // Passes from 1 on take up what earlier ones left undecided; the upload zeroed the counts of
    // all.
    void record_passes(std::uint32_t first_pass) {
        if (first_pass > 0) state_.begin_more_passes();
        // A candidate looks at all columns within its reach, and at their candidates.
        constexpr double kTurnsOfColumn = 4;
        const double near = kTurnsOfColumn * widest_.share_of_lines * state_.geometry.columns +
                            widest_.share * state_.draw_count;
        const std::uint32_t chunk = chunk_of(static_cast<std::uint64_t>(near) + 16);
        for (std::uint32_t pass = first_pass; pass < kPasses; ++pass) {
            engine_->dispatch(
                kernels_.admit,
                {state_.column_begins, state_.buckets, state_.candidates, state_.candidate_radii,
                 state_.column_of, state_.row_of, state_.pixel_reaches, state_.fates,
                 state_.undecided, state_.samples, state_.failure},
                AdmitInCellsArguments{0, state_.geometry, rows(), metric(), pass, state_.draw_count,
                                      chunk},
                items_of(chunk), (pass == 0 ? kAdmitWork : 1) * chunk);
            engine_->barrier();
        }
        has_fates_ = true;
    }

    void record_subtract() {
        engine_->fill(state_.left_count, 0, kWord);
        engine_->barrier();
        served_reach_ = short_reach_;
        record_cuts(state_.draw_count, 0, mean_reach_);
    }

    // What reaches farther comes after, twice as far at a time.
    void record_cuts_of_left() {
        std::swap(state_.todo, state_.left);
        engine_->fill(state_.left_count, 0, kWord);
        engine_->barrier();
        served_reach_ = std::min(2 * served_reach_, widest_.reach);
        record_cuts(left(), 1, served_reach_);
    }

    void record_cuts(std::uint32_t count, std::uint32_t is_listed, std::uint32_t usual_reach) {
        // Fewer slices where there would be more items than can be counted; then there are enough.
        const std::uint32_t most =
            std::numeric_limits<std::uint32_t>::max() / 2 / std::max(count, 1u);
        const std::uint32_t slices =
            std::min(slices_of(state_.plan, served_reach_), std::max(most, 1u));
        engine_->dispatch(
            kernels_.subtract,
            {state_.undecided, state_.candidates, state_.fates, state_.column_of, state_.row_of,
             state_.row_begins, state_.pixel_radii, state_.pixel_reaches, state_.widest_rows,
             state_.widest, state_.bits, state_.free_lengths, state_.todo, state_.left,
             state_.left_count, state_.failure},
            SubtractInCellsArguments{0, state_.geometry, state_.words, rows(), metric(),
                                     kPasses - 1, count, slices, served_reach_, is_listed},
            count * slices, subtract_work(state_.plan, usual_reach, slices));
        engine_->barrier();
    }

    std::uint32_t left() const { return state_.left_count_down.as<std::uint32_t>().front(); }

    // Waits until the verbs are done, with what more it takes: passes, or cuts.
    void finish() {
        while (is_recorded_) {
            state_.download();
            engine_->wait();
            if (dispatches_ != nullptr) *dispatches_ = engine_->dispatches();
            state_.throw_if_failed();
            is_recorded_ = false;
            if (state_.is_unsettled()) {
                record_passes(1);
                is_recorded_ = true;
                if (subtracts_) record_subtract();
            } else if (subtracts_ && left() > 0) {
                record_cuts_of_left();
                is_recorded_ = true;
            }
        }
        subtracts_ = false;
    }

    std::unique_ptr<Engine> engine_;
    CellsKernels kernels_;
    CellsState state_;
    Widest widest_;
    std::uint32_t short_reach_;
    std::uint32_t mean_reach_;
    std::uint32_t served_together_;
    std::uint32_t served_reach_ = 0;  // of subtract, so far
    std::uint64_t* dispatches_;
    std::vector<Sample> samples_;
    bool is_recorded_ = false;  // something whose outcome is not known yet
    bool has_fates_ = false;    // passes have something to take up
    bool subtracts_ = false;    // at the end of the round
};

}  // namespace

std::unique_ptr<Backend> make_cells_backend(std::unique_ptr<Engine> engine, const Plan& plan,
                                            const Trial& trial) {
    return std::make_unique<CellsBackend>(std::move(engine), plan, trial);
}

}  // namespace lacuna::vulkan
