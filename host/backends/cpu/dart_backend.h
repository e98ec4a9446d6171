// admit in exact, on the sample grid or with a radius field.
#pragma once

#include <algorithm>
#include <cstdint>

#include "backends/cpu/darts.h"
#include "backends/cpu/round_backend.h"

namespace lacuna::cpu {

// Mode exact: the round's draws are thrown one after another.
template <typename DartState>
class DartBackend : public RoundBackend<DartState> {
public:
    using RoundBackend<DartState>::RoundBackend;

protected:
    using RoundBackend<DartState>::state_;
    using RoundBackend<DartState>::stage_;

    // Decides the round's candidates, in at most most_slabs slabs.
    void throw_darts(std::uint32_t most_slabs) {
        const auto count = static_cast<std::uint32_t>(state_.candidates.size());
        if (stage_ == Stage::restored)
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
        stage_ = Stage::admitted;
    }

private:
    // Draws per slab between two chances to cancel the run: they take some 0.02 s.
    static constexpr std::uint32_t kTurnsAtOnce = std::uint32_t{1} << 17;
    // Fewer draws take one thread less time than it takes to divide them among slabs.
    static constexpr std::uint32_t kDrawsWorthSlabs = 4096;

    Darts darts_;
};

}  // namespace lacuna::cpu
