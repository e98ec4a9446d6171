// The cpu backend: the verbs in which the modes differ.
#include "backends/cpu/make_backend.h"

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "backends/cpu/round_backend.h"
#include "backends/cpu/state.h"

namespace lacuna::cpu {
namespace {

// Modes lines and exact.
class SpanBackend : public RoundBackend<SpanState> {
public:
    using RoundBackend::RoundBackend;

    void admit() override {
        if (state_.grid)
            for_columns(state_.candidates.size(),
                        [&](std::uint32_t column) { cpu::screen(state_, column); });
        RoundBackend::admit();
    }

    void subtract() override {
        insert();
        while (!all_columns([&](std::uint32_t column) { return cpu::subtract(state_, column); }))
            state_.grow();
    }

    void refine(bool halve) override {
        insert();
        const std::uint32_t width = state_.place_width >> (halve ? 1 : 0);
        for_columns(state_.place_begins.back(),
                    [&](std::uint32_t column) { cpu::refine(state_, column, width); });
        state_.settle_boxes(width);
    }

private:
    void insert() {
        if (state_.grid)
            for_columns(state_.candidates.size(),
                        [&](std::uint32_t column) { cpu::insert(state_, column); });
    }
};

class CellsBackend : public RoundBackend<BitState> {
public:
    using RoundBackend::RoundBackend;

    void subtract() override {
        state_.find_near();
        for_columns(state_.near.size(),
                    [&](std::uint32_t column) { cpu::subtract(state_, column); });
    }

    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    if (plan.is_cells()) return std::make_unique<CellsBackend>(plan, placement.threads);
    return std::make_unique<SpanBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu
