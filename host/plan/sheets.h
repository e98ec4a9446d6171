// The classes of a plan's samples: on which sheet each lies, which distances they keep, and how
// often each is drawn. The arithmetic is in portable/sheets.h.
#pragma once

#include <lacuna/lacuna.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "portable/conflict.h"

namespace lacuna {

class Sheets {
public:
    // One class, and one sheet: the domain.
    Sheets();
    // `distances` is a matrix, as distances_of() returns it. Factors are exact enough for samples
    // of up to `most_radius`, in grid units.
    Sheets(std::uint32_t count, std::span<const double> distances, std::span<const double> weights,
           std::uint32_t most_radius = 0);

    std::uint32_t count() const { return count_; }
    bool are_several() const { return count_ > 1; }
    std::uint32_t bits() const { return bits_; }
    std::uint32_t of(std::uint32_t x) const { return portable::sheet_of(x, bits_); }
    std::uint32_t begin_of(std::uint32_t sheet) const { return count_ == 1 ? 0 : sheet << bits_; }
    // All bits that x may have on one sheet, and on one of `count`.
    std::uint32_t last() const { return (std::uint32_t{1} << bits_) - 1; }
    static std::uint32_t last_of(std::uint32_t count) {
        return ~std::uint32_t{0} >> (count <= 1 ? 1 : count <= 4 ? 2 : count <= 8 ? 3 : 4);
    }
    std::uint32_t x_on_sheet(std::uint32_t x) const { return x & last(); }
    std::uint32_t x_on(std::uint32_t sheet, std::uint32_t x) const {
        return x_on_sheet(x) + begin_of(sheet);
    }

    // The factor with which samples of two classes keep their distance.
    std::uint64_t factor(std::uint32_t a, std::uint32_t b) const {
        return factors_[a * std::size_t{MOST_CLASSES} + b];
    }
    // The greatest factor of a class with any other.
    std::uint64_t greatest_factor(std::uint32_t sheet) const;
    // The factor by which first boxes are long on the sheet. It is that within the class. But if
    // samples of another class may lie far closer together, boxes are shorter, so that a block has
    // at most some hundred neighbours.
    std::uint64_t factor_of_boxes(std::uint32_t sheet) const;
    std::span<const std::uint64_t> factors() const { return factors_; }

    // A class is drawn in proportion to its weight and its free area. One of weight 0 is never
    // drawn: its samples are kept points.
    std::uint32_t weight(std::uint32_t sheet) const { return weights_[sheet]; }

private:
    std::uint32_t count_;
    std::uint32_t bits_;
    // MOST_CLASSES to a row.
    std::array<std::uint64_t, std::size_t{MOST_CLASSES} * MOST_CLASSES> factors_{};
    std::vector<std::uint32_t> weights_;  // the greatest is 2^16, others are at least 1, or 0
};

// The sheets of a request, which was checked. Without classes there is one.
Sheets sheets_of(const Request& request, std::uint32_t most_radius = 0);

// The least distances of a request's classes, class by class in rows, as shares of the least that
// is not 0. Without classes there is one distance.
std::vector<double> distances_of(const Request& request);
// The least distance that is not 0, in the request's unit, which Request::radius or scale stand
// for. Infinite if there is none.
double least_distance_of(const Classes& classes);
// The distances that classes keep in a set, over those of its request: not 1 if the request has a
// count, or a radius or scale of its own.
double distance_factor(const Request& request, const Result& result);

// Where samples of a class may lie: its own border and mask, or those of the request. The class is
// 0 in a request without classes.
double border_of(const Request& request, std::size_t of_class);
const Mask* mask_of(const Request& request, std::size_t of_class);
// Whether a class may have a border or a mask of its own.
bool has_own_places(const Classes& classes);
// Whether a class has a number of points.
bool has_counts(const Classes& classes);
// Whether a class is drawn until it has no room, so that a set may be maximal: one that has a
// weight and no number of points, or no class at all.
bool has_open_class(const Classes& classes);

// Checks that there is none of `what`, or one for each class. Throws BadRequest.
void check_each(const Classes& classes, const char* option, std::size_t size, const char* what);
// Checks the distances of classes that have names. Throws BadRequest.
void check_distances(const Classes& classes);
// Checks the names, radii, weights and distances of classes. Throws BadRequest.
void check_classes(const Request& request);

}  // namespace lacuna
