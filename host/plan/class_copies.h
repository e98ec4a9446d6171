// The classes of samples: on which copy of the domain each lies, which distances they keep, and how
// often each is drawn. The arithmetic is in portable/class_copies.h.
#pragma once

#include <lacuna/lacuna.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "portable/conflict.h"

namespace lacuna {

class ClassCopies {
public:
    // One class, and one copy: the domain.
    ClassCopies();
    // `distances` is a matrix, as distances_of() returns it. Factors are exact enough for samples
    // of up to `most_radius`, in grid units.
    ClassCopies(std::uint32_t count, std::span<const double> distances,
                std::span<const double> weights, std::uint32_t most_radius = 0);

    std::uint32_t count() const { return count_; }
    bool are_several() const { return count_ > 1; }
    std::uint32_t bits() const { return bits_; }
    std::uint32_t of(std::uint32_t x) const { return portable::copy_of(x, bits_); }
    std::uint32_t begin_of(std::uint32_t copy) const { return count_ == 1 ? 0 : copy << bits_; }
    // All bits that x may have on one copy, and on one of `count`.
    std::uint32_t last() const { return (std::uint32_t{1} << bits_) - 1; }
    static std::uint32_t last_of(std::uint32_t count) {
        return ~std::uint32_t{0} >> (count <= 1 ? 1 : count <= 4 ? 2 : count <= 8 ? 3 : 4);
    }
    std::uint32_t x_on_copy(std::uint32_t x) const { return x & last(); }
    std::uint32_t x_on(std::uint32_t copy, std::uint32_t x) const {
        return x_on_copy(x) + begin_of(copy);
    }

    // The factor with which samples of two classes keep their distance.
    std::uint64_t factor(std::uint32_t a, std::uint32_t b) const {
        return factors_[a * std::size_t{MOST_CLASSES} + b];
    }
    // The greatest factor of a class with any other.
    std::uint64_t greatest_factor(std::uint32_t copy) const;
    // The factor by which first boxes are long on the copy. It is that within the class. But if
    // samples of another class may lie far closer together, boxes are shorter, so that a block has
    // at most some hundred neighbours.
    std::uint64_t factor_of_boxes(std::uint32_t copy) const;
    std::span<const std::uint64_t> factors() const { return factors_; }

    // A class is drawn in proportion to its weight and its free area. One of weight 0 is never
    // drawn: its samples are kept points.
    std::uint32_t weight(std::uint32_t copy) const { return weights_[copy]; }

private:
    std::uint32_t count_;
    std::uint32_t bits_;
    // MOST_CLASSES to a row.
    std::array<std::uint64_t, std::size_t{MOST_CLASSES} * MOST_CLASSES> factors_{};
    std::vector<std::uint32_t> weights_;  // the greatest is 2^16, others are at least 1, or 0
};

// The copies of a request, which was checked. Without classes there is one.
ClassCopies copies_of(const Request& request, std::uint32_t most_radius = 0);

}  // namespace lacuna
