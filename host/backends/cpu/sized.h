// Samples with their radii, an array for each member, as vector instructions read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::cpu {

// kVectorPadding entries past the end must exist, because they may be read (vectors.h).
struct SizedSpan {
    const std::uint32_t* x;
    const std::uint32_t* y;
    const std::uint32_t* radius;
    std::size_t count;

    Sized operator[](std::size_t i) const { return {x[i], y[i], radius[i]}; }
    SizedSpan from(std::size_t first) const { return part(first, count - first); }
    SizedSpan part(std::size_t first, std::size_t entries) const {
        return {x + first, y + first, radius + first, entries};
    }
};

class SizedList {
public:
    std::size_t size() const { return count_; }
    void clear() { count_ = 0; }
    void push_back(const Sized& sample);
    void append(const SizedSpan& samples);
    // With classes: becomes the samples as a sheet sees them (plan/sheets.h). Their radii become
    // the distances that they keep there from samples of `radius`.
    void see(const Sheets& sheets, std::uint32_t sheet, const SizedSpan& samples,
             std::uint32_t radius);
    SizedSpan span() const { return {x_.data(), y_.data(), radius_.data(), count_}; }

private:
    void make_room(std::size_t count);

    std::size_t count_ = 0;
    std::vector<std::uint32_t> x_;  // padded past count_
    std::vector<std::uint32_t> y_;
    std::vector<std::uint32_t> radius_;
};

// Larger than every radius: the smaller of a radius and this is the radius.
inline constexpr std::uint32_t kAnyRadius = ~std::uint32_t{0};

}  // namespace lacuna::cpu
