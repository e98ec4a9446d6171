// Samples with their radii, an array for each member, as vector instructions read them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::cpu {

// Buffers are padded by this many entries: the loops of vectors.h read and write that far past the
// end.
inline constexpr std::size_t kVectorPadding = 8;

// Padded past the end.
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
    void push_back(const Sized& sample) {
        make_room(count_ + 1);
        x_[count_] = sample.x;
        y_[count_] = sample.y;
        radius_[count_++] = sample.radius;
    }
    void append(const SizedSpan& samples) {
        make_room(count_ + samples.count);
        std::copy_n(samples.x, samples.count, &x_[count_]);
        std::copy_n(samples.y, samples.count, &y_[count_]);
        std::copy_n(samples.radius, samples.count, &radius_[count_]);
        count_ += samples.count;
    }
    // With classes: becomes the samples as a copy sees them (plan/class_copies.h). Their radii
    // become the distances that they keep there from samples of `radius`.
    void see(const ClassCopies& copies, std::uint32_t copy, const SizedSpan& samples,
             std::uint32_t radius) {
        make_room(samples.count);
        count_ = samples.count;
        // Read once: the compiler cannot know that the arrays do not overlap the copies.
        const std::uint32_t begin = copies.begin_of(copy), last = copies.last();
        const std::uint32_t bits = copies.bits();
        const std::uint64_t* const factors = &copies.factors()[copy * std::size_t{MOST_CLASSES}];
        for (std::size_t i = 0; i < samples.count; ++i) {
            x_[i] = (samples.x[i] & last) + begin;
            y_[i] = samples.y[i];
            radius_[i] = portable::times_factor(std::min(samples.radius[i], radius),
                                                factors[portable::copy_of(samples.x[i], bits)]);
        }
    }
    SizedSpan span() const { return {x_.data(), y_.data(), radius_.data(), count_}; }

private:
    void make_room(std::size_t count) {
        if (count + kVectorPadding <= x_.size()) return;
        for (std::vector<std::uint32_t>* const words : {&x_, &y_, &radius_})
            words->resize(std::max(count + kVectorPadding, 2 * x_.size()));
    }

    std::size_t count_ = 0;
    std::vector<std::uint32_t> x_;  // padded past count_
    std::vector<std::uint32_t> y_;
    std::vector<std::uint32_t> radius_;
};

// Larger than every radius: the smaller of a radius and this is the radius.
inline constexpr std::uint32_t kAnyRadius = ~std::uint32_t{0};

}  // namespace lacuna::cpu
