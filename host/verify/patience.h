// Whether a proof is still wanted: asked often, by every thread that works at it.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>

namespace lacuna::verify {

class Patience {
public:
    Patience() = default;
    explicit Patience(const std::function<bool()>& keep_going) : keep_going_(&keep_going) {}

    // Throws Cancelled once the proof is not wanted any more.
    void look() const {
        if (keep_going_ != nullptr && *keep_going_ && !(*keep_going_)()) throw Cancelled();
    }

    // `less` as an order to sort by, which looks now and then: millions of points take a second.
    template <typename Less>
    auto looking(Less less) const {
        return [this, less, asked = std::uint32_t{0}](const auto& a, const auto& b) mutable {
            constexpr std::uint32_t kSeldom = 1U << 14U;
            if (++asked % kSeldom == 0) look();
            return less(a, b);
        };
    }

private:
    const std::function<bool()>* keep_going_ = nullptr;  // null: nobody asks to stop
};

}  // namespace lacuna::verify
