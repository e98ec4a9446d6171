// Checks fields and masks.
#include "checks/pixels.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/polling.h"

namespace lacuna {
namespace {

constexpr double kMostStretch = 1000;  // of an ellipse's radii
constexpr double kMostAngle = 1000;    // radians

}  // namespace

bool check_values(const Field& field) {
    if (field.importance.size() != std::size_t{field.columns} * field.rows ||
        field.importance.empty())
        throw BadRequest("field",
                         std::to_string(field.columns) + "x" + std::to_string(field.rows) +
                             " with " + std::to_string(field.importance.size()) + " values",
                         "needs columns * rows values, at least one");
    // One pass without a branch, because there may be 2^28 pixels. The highest bit of a number is
    // its sign. Adding a unit of the exponent carries into it if the number is not finite.
    std::uint64_t any = 0, carried = 0;
    for_each_polled(field.importance.size(), ask, [&](std::size_t i) {
        const auto bits = std::bit_cast<std::uint64_t>(field.importance[i]);
        any |= bits;
        carried |= bits + (std::uint64_t{1} << 52U);
    });
    const bool is_fine = (any | carried) >> 63U == 0;
    const bool is_zero = any << 1U == 0;  // of either sign
    for (std::size_t i = 0; !is_fine && i < field.importance.size(); ++i)
        if (!std::isfinite(field.importance[i]) || field.importance[i] < 0)
            throw BadRequest("field",
                             shortest(field.importance[i]) + " at row " +
                                 std::to_string(i / field.columns) + ", column " +
                                 std::to_string(i % field.columns),
                             "importance must be a finite number of at least 0");
    return !is_zero;
}

void check_importance(const Field& field) {
    if (!check_values(field))
        throw BadRequest("field", "of zeros", "some importance must be greater than 0");
}

void check_stretches(const Field& field) {
    const std::vector<Stretch>& stretches = field.stretches;
    if (stretches.empty()) return;
    if (stretches.size() != field.importance.size())
        throw BadRequest("stretches", std::to_string(stretches.size()) + " values",
                         "there must be one for each pixel of the field, " +
                             std::to_string(field.importance.size()));
    for_each_polled(stretches.size(), ask, [&](std::size_t i) {
        if (const auto& [ratio, angle] = stretches[i];
            !(ratio >= 1 && ratio <= kMostStretch) || !(std::abs(angle) <= kMostAngle))
            throw BadRequest("stretches",
                             shortest(ratio) + " at an angle of " + shortest(angle) + " at row " +
                                 std::to_string(i / field.columns) + ", column " +
                                 std::to_string(i % field.columns),
                             "ratios must lie between 1 and " + shortest(kMostStretch) +
                                 ", angles between -" + shortest(kMostAngle) + " and " +
                                 shortest(kMostAngle));
    });
}

void check_disks(const Field& field, const char* who) {
    if (!field.stretches.empty())
        throw BadRequest("stretches", std::string("for ") + who, "are for mode exact of sample");
}

void check_mask(const Mask& mask) {
    if (mask.drawn) return;  // drawing has checked it
    const std::string size = std::to_string(mask.columns) + "x" + std::to_string(mask.rows);
    if (mask.allowed.size() != std::size_t{mask.columns} * mask.rows || mask.allowed.empty())
        throw BadRequest("mask", size + " with " + std::to_string(mask.allowed.size()) + " values",
                         "needs columns * rows values, at least one");
}

}  // namespace lacuna
