// How many samples of a plan are wanted: up to its limit, or up to the one that gives a class its
// number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "plan/plan.h"

namespace lacuna {

class Quota {
public:
    explicit Quota(const Plan& plan)
        : plan_(plan), left_(plan.limit), left_of_classes_(plan.class_limits) {}

    bool is_met() const { return left_ == 0; }

    // The first samples of a round, up to the one that meets the quota; all if none does.
    template <typename Placed>
    std::span<const Placed> wanted(std::span<const Placed> samples) {
        auto count = static_cast<std::size_t>(std::min<std::uint64_t>(samples.size(), left_));
        if constexpr (std::is_same_v<Placed, Sample>)  // in space there are no classes
            for (std::size_t i = 0; !left_of_classes_.empty() && i < count; ++i)
                if (--left_of_classes_[plan_.class_of(samples[i])] == 0) left_ = count = i + 1;
        left_ -= count;
        return samples.first(count);
    }

private:
    const Plan& plan_;
    std::uint64_t left_;
    std::vector<std::uint64_t> left_of_classes_;
};

}  // namespace lacuna
