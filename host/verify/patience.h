// Asks whether a proof is still wanted. Every thread that works at the proof asks often.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>

#include "base/polling.h"

namespace lacuna::verify {

class Patience {
public:
    Patience() = default;
    explicit Patience(const std::function<bool()>& keep_going) : keep_going_(&keep_going) {}

    // Throws Cancelled if the proof is not wanted any more.
    void look() const {
        ask();
        if (keep_going_ != nullptr && *keep_going_ && !(*keep_going_)()) throw Cancelled();
    }

    // Makes of `less` an order for sorting that calls look() now and then, because sorting millions
    // of points takes a second.
    template <typename Less>
    auto looking(Less less) const {
        return [this, less, asked = std::uint32_t{0}](const auto& a, const auto& b) mutable {
            constexpr std::uint32_t kCallsPerLook = 1U << 14U;
            if (++asked % kCallsPerLook == 0) look();
            return less(a, b);
        };
    }

private:
    const std::function<bool()>* keep_going_ = nullptr;  // null: the proof is always wanted
};

}  // namespace lacuna::verify
