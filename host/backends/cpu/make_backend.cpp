// The cpu backend: the verbs in which the modes differ.
#include "backends/cpu/make_backend.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "backends/cpu/dart_backend.h"
#include "backends/cpu/round_backend.h"
#include "backends/cpu/state.h"

namespace lacuna::cpu {
namespace {

// Modes lines and exact.
class SpanBackend : public DartBackend<SpanState> {
public:
    using DartBackend::DartBackend;

    void admit() override {
        if (!state_.grid) return admit_by_passes([&] { cut(); });
        throw_darts(slabs());
    }

    void subtract() override {
        insert();
        if (stage_ != Stage::cut) cut();
        stage_ = Stage::cut;
    }

    void refine(bool halve) override {
        insert();
        const std::uint32_t width = state_.bin_width >> (halve ? 1 : 0);
        for_columns(state_.bin_begins.back(),
                    [&](std::uint32_t column) { cpu::refine(state_, column, width); });
        state_.settle_boxes(width);
        stage_ = Stage::cut;
    }

private:
    void insert() {
        if (state_.grid && stage_ != Stage::admitted)
            for_columns(state_.candidates.size(),
                        [&](std::uint32_t column) { cpu::insert(state_, column); });
    }
    void cut() {
        while (!all_columns([&](std::uint32_t column) { return cpu::subtract(state_, column); }))
            state_.grow();
    }
};

class CellsBackend : public RoundBackend<BitState> {
public:
    using RoundBackend::RoundBackend;

    void admit() override {
        admit_by_passes([&] { cut(); });
    }

    void subtract() override {
        if (stage_ != Stage::cut) cut();
        stage_ = Stage::cut;
    }

    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }

private:
    void cut() {
        state_.find_near([&] { poll(); });
        for_columns(state_.near.size(),
                    [&](std::uint32_t column) { cpu::subtract(state_, column); });
    }
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    if (plan.has_field()) return make_field_backend(plan, placement);
    if (plan.is_cells()) return std::make_unique<CellsBackend>(plan, placement.threads);
    return std::make_unique<SpanBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu
