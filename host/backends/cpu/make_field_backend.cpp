// The cpu backend of mode exact with a radius field.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "backends/cpu/dart_backend.h"
#include "backends/cpu/field_state.h"
#include "backends/cpu/make_backend.h"

namespace lacuna::cpu {
namespace {

class FieldBackend : public DartBackend<FieldState> {
public:
    using DartBackend::DartBackend;

    void admit() override {
        const auto zones = static_cast<std::uint32_t>(state_.first.zones.size());
        throw_darts(std::max(zones, std::uint32_t{1}));
    }

    void subtract() override { throw std::logic_error("a radius field is refined from the start"); }

    void refine(bool halve) override {
        if (stage_ != Stage::admitted) state_.insert_admitted();
        for_columns(state_.bin_begins.back(),
                    [&](std::uint32_t region) { cpu::refine(state_, region, halve); });
        state_.measure_boxes();
        for_columns(state_.bin_begins.back(),
                    [&](std::uint32_t region) { state_.measure_boxes(region); });
        stage_ = Stage::cut;
    }
};

}  // namespace

std::unique_ptr<Backend> make_field_backend(const Plan& plan, const Placement& placement) {
    return std::make_unique<FieldBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu
