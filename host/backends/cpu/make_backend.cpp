// The cpu backend: the verbs in which the modes differ.
#include "backends/cpu/make_backend.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>

#include "backends/cpu/darts.h"
#include "backends/cpu/round_backend.h"
#include "backends/cpu/state.h"

namespace lacuna::cpu {
namespace {

// Mode exact: the round's draws are thrown one after another.
template <typename DartState>
class DartBackend : public RoundBackend<DartState> {
public:
    using RoundBackend<DartState>::RoundBackend;

protected:
    using RoundBackend<DartState>::state_;

    // In so many slabs, unless that is not worth it.
    void throw_darts(std::uint32_t most_slabs) {
        const auto count = static_cast<std::uint32_t>(state_.candidates.size());
        if (!std::exchange(state_.is_screened, false))
            this->for_columns(count, [&](std::uint32_t column) { cpu::screen(state_, column); });
        const std::uint32_t slabs = count < kDrawsWorthSlabs ? 1 : most_slabs;
        for (std::uint32_t end, begin = 0; begin < count; begin = end) {
            const std::uint32_t draws = std::min(kTurnsAtOnce * slabs, count - begin);
            end = begin + draws;
            darts_.begin(begin, end, slabs);
            this->for_slabs(slabs, draws,
                            [&](std::uint32_t slab) { darts_.throw_in(state_, slab); });
            darts_.finish(state_, [&] { this->poll(); });
        }
    }

private:
    // In each slab: thrown in some 0.02 s, after which a run can be cancelled.
    static constexpr std::uint32_t kTurnsAtOnce = std::uint32_t{1} << 17;
    // Fewer take one thread less time than slabs take to share out.
    static constexpr std::uint32_t kDrawsWorthSlabs = 4096;

    Darts darts_;
};

// Modes lines and exact.
class SpanBackend : public DartBackend<SpanState> {
public:
    using DartBackend::DartBackend;

    void admit() override {
        if (!state_.grid) return admit_by_passes([&] { take_out(); });
        throw_darts(slabs());
        state_.is_inserted = true;
    }

    void subtract() override {
        insert();
        if (!std::exchange(is_cut_, false)) cut();
    }

    void refine(bool halve) override {
        insert();
        const std::uint32_t width = state_.place_width >> (halve ? 1 : 0);
        for_columns(state_.place_begins.back(),
                    [&](std::uint32_t column) { cpu::refine(state_, column, width); });
        state_.settle_boxes(width);
    }

private:
    void take_out() {
        cut();
        is_cut_ = true;
    }
    void insert() {
        if (state_.grid && !std::exchange(state_.is_inserted, false))
            for_columns(state_.candidates.size(),
                        [&](std::uint32_t column) { cpu::insert(state_, column); });
    }
    void cut() {
        while (!all_columns([&](std::uint32_t column) { return cpu::subtract(state_, column); }))
            state_.grow();
    }

    bool is_cut_ = false;  // by take_out: nothing is left to subtract
};

class GroundBackend : public DartBackend<GroundState> {
public:
    using DartBackend::DartBackend;

    void admit() override { throw_darts(state_.columns); }

    void subtract() override { throw std::logic_error("a ground is refined from the start"); }

    void refine(bool halve) override {
        for_columns(state_.place_begins.back(),
                    [&](std::uint32_t region) { cpu::refine(state_, region, halve); });
        state_.settle_places();
    }
};

class CellsBackend : public RoundBackend<BitState> {
public:
    using RoundBackend::RoundBackend;

    void admit() override {
        admit_by_passes([&] {
            cut();
            is_cut_ = true;
        });
    }

    void subtract() override {
        if (!std::exchange(is_cut_, false)) cut();
    }

    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }

private:
    void cut() {
        state_.find_near([&] { poll(); });
        for_columns(state_.near.size(),
                    [&](std::uint32_t column) { cpu::subtract(state_, column); });
    }

    bool is_cut_ = false;  // by take_out: nothing is left to subtract
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    if (plan.ground) return std::make_unique<GroundBackend>(plan, placement.threads);
    if (plan.is_cells()) return std::make_unique<CellsBackend>(plan, placement.threads);
    return std::make_unique<SpanBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu
