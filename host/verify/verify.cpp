// Refuses claims that make no sense.
#include "verify/verify.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "places/sets.h"
#include "verify/neighbours.h"

namespace lacuna::verify {
namespace {

constexpr double kSmallestSide = 1e-100;
constexpr double kLargestSide = 1e100;
constexpr double kLargestAspect = 1000;
constexpr double kFarthestCorner = 0x1p20;  // from 0, in longer sides
constexpr double kLargestRatio = 1000;      // of an ellipse's radii

void check_positive(const char* option, double value) {
    if (!std::isfinite(value) || value <= 0)
        throw BadRequest(option, text(value), "must be a finite number greater than 0");
}

void check_at_least_0(const char* option, double value) {
    if (!std::isfinite(value) || value < 0)
        throw BadRequest(option, text(value), "must be a finite number of at least 0");
}

void check_pixels(const char* option, std::uint32_t columns, std::uint32_t rows,
                  std::size_t values) {
    const std::string size = std::to_string(columns) + "x" + std::to_string(rows);
    if (columns == 0 || rows == 0) throw BadRequest(option, size, "must have a pixel");
    if (values != std::size_t{columns} * rows)
        throw BadRequest(option, size,
                         "must have columns * rows values, not " + std::to_string(values));
}

void check_field(const Field& field) {
    check_pixels("field", field.columns, field.rows, field.importance.size());
    for (const double importance : field.importance)
        if (!std::isfinite(importance) || importance < 0)
            throw BadRequest("field", text(importance),
                             "importance must be a finite number of at least 0");
}

void check_stretches(const Claim& claim) {
    const std::vector<Stretch>& stretches = claim.field->stretches;
    if (stretches.empty()) return;
    if (stretches.size() != claim.field->importance.size())
        throw BadRequest("stretches", std::to_string(stretches.size()) + " values",
                         "must be " + std::to_string(claim.field->importance.size()) +
                             ", one for each pixel of the field");
    for (const auto& [ratio, angle] : stretches)
        if (!(ratio >= 1 && ratio <= kLargestRatio) || !std::isfinite(angle))
            throw BadRequest("stretches", text(ratio) + " at an angle of " + text(angle),
                             "ratios must lie between 1 and 1000, and angles must be finite");
    if (!claim.classes.names.empty())
        throw BadRequest("class", "with ellipses", "classes have disks");
}

void check_mask(const Mask* mask) {
    if (mask == nullptr) return;
    if (mask->drawn)
        throw BadRequest("mask", "drawn from polygons", "give the polygons themselves");
    check_pixels("mask", mask->columns, mask->rows, mask->allowed.size());
}

void check_border(const Claim& claim, double border) {
    check_at_least_0("border", border);
    if (border > 0 && claim.domain.wraps())
        throw BadRequest("border", text(border), "is not for a torus, which has no edges");
}

// Where points may lie.
void check_places(const Claim& claim) {
    const Classes& classes = claim.classes;
    const std::size_t count = classes.names.size();
    for (const auto& [option, size] :
         {std::pair{"border", classes.borders.size()}, std::pair{"mask", classes.masks.size()}})
        if (size != 0 && size != count)
            throw BadRequest(option, "for " + std::to_string(size) + " classes",
                             "must be for each of the " + std::to_string(count) + " classes");
    check_mask(claim.mask);
    for (const Mask* const mask : classes.masks) check_mask(mask);
    places::check(claim);
    check_border(claim, claim.border);
    for (const double border : classes.borders) check_border(claim, border);
}

}  // namespace

std::string text(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

void check_domain(const lacuna::Domain& domain) {
    std::string sides = text(domain.width) + "x" + text(domain.height);
    if (domain.has_corner()) sides = text(domain.x0) + "," + text(domain.y0) + "+" + sides;
    const double shorter = domain.shorter_side();
    const double longer = domain.longer_side();
    if (!std::isfinite(domain.width) || !std::isfinite(domain.height) || shorter <= 0)
        throw BadRequest("domain", sides, "both sides must be finite numbers greater than 0");
    if (shorter < kSmallestSide || longer > kLargestSide)
        throw BadRequest("domain", sides, "the sides must lie between 1e-100 and 1e100");
    if (longer > kLargestAspect * shorter)
        throw BadRequest("domain", sides, "the longer side may be at most 1000 times the shorter");
    // This condition is also false for NaN.
    if (!(std::max(std::abs(domain.x0), std::abs(domain.y0)) <= kFarthestCorner * longer &&
          std::isfinite(domain.x0 + domain.y0)))
        throw BadRequest("domain", sides,
                         "the corner may be at most " + text(kFarthestCorner * longer) +
                             " from 0 along either axis, 2^20 times the longer side, or doubles "
                             "run out of digits");
}

namespace {

// What samplers ask of classes besides, such as names without commas, is no matter of a proof.
void check_classes(const Claim& claim, std::size_t points) {
    const Classes& classes = claim.classes;
    const std::size_t count = classes.names.size();
    if (count == 0) return;
    if (classes.distances.size() != count * count)
        throw BadRequest("between", std::to_string(classes.distances.size()) + " distances",
                         "must be " + std::to_string(count * count) + ", for " +
                             std::to_string(count) + " classes");
    for (std::size_t i = 0; i < count * count; ++i) {
        const double distance = classes.distances[i];
        if (!std::isfinite(distance) || distance < 0 || (i % (count + 1) == 0 && distance == 0) ||
            distance != classes.distances[i % count * count + i / count])
            throw BadRequest("between",
                             classes.names[i / count] + " and " + classes.names[i % count] +
                                 " keep " + text(distance),
                             "distances must be finite, at least 0, the same both ways, and those "
                             "within a class greater than 0");
    }
    if (!classes.weights.empty() && classes.weights.size() != count)
        throw BadRequest("class", std::to_string(classes.weights.size()) + " weights",
                         "must be " + std::to_string(count) + ", one for each class");
    if (!classes.counts.empty() && classes.counts.size() != count)
        throw BadRequest("class", std::to_string(classes.counts.size()) + " numbers of points",
                         "must be " + std::to_string(count) + ", one for each class");
    if (claim.class_of_points.size() != points)
        throw BadRequest("class", std::to_string(claim.class_of_points.size()) + " points",
                         "have a class, but there are " + std::to_string(points) + " points");
    for (const std::uint8_t kind : claim.class_of_points)
        if (kind >= count)
            throw BadRequest(
                "class", std::to_string(kind),
                "must be less than " + std::to_string(count) + ", the number of classes");
}

void check_neighbours(const Claim& claim) {
    const Outside outside(claim);
    const auto is_one = [&](Point kept) { return outside.has(kept); };
    const auto first = std::find_if(claim.keep.begin(), claim.keep.end(), is_one);
    if (first == claim.keep.end()) return;
    if (!std::isfinite(first->x) || !std::isfinite(first->y) || claim.field != nullptr)
        throw BadRequest("keep",
                         "point " + std::to_string(first - claim.keep.begin()) + " at (" +
                             text(first->x) + ", " + text(first->y) + ")",
                         claim.field != nullptr ? "with a field must lie in the domain"
                                                : "must be finite numbers");
    const std::size_t count = claim.classes.names.size();
    if (count != 0 && claim.keep_classes.size() != claim.keep.size())
        throw BadRequest("keep", std::to_string(claim.keep.size()) + " points",
                         "with classes each needs a class, but " +
                             std::to_string(claim.keep_classes.size()) + " have one");
    for (const std::uint8_t kind : claim.keep_classes)
        if (count != 0 && kind >= count)
            throw BadRequest(
                "keep", "class " + std::to_string(kind),
                "must be less than " + std::to_string(count) + ", the number of classes");
}

}  // namespace

double least_distance(const Classes& classes) {
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : classes.distances)
        if (distance > 0) least = std::min(least, distance);
    return least;
}

std::vector<double> shares_of(const Claim& claim) {
    std::vector<double> shares = claim.classes.distances;
    const double least = least_distance(claim.classes);
    for (double& share : shares) share /= least;
    return shares;
}

void check_claim(const Claim& claim, std::size_t points, double tolerance) {
    check_domain(claim.domain);
    const bool has_classes = !claim.classes.names.empty();
    if (claim.field != nullptr) {
        check_field(*claim.field);
        check_stretches(claim);
        if (!has_classes || claim.scale != 0) check_positive("scale", claim.scale);
    } else if (!has_classes || claim.radius != 0) {
        check_positive("radius", claim.radius);
    }
    check_classes(claim, points);
    check_neighbours(claim);
    // Without gaps to look for, a uniform set needs no tolerance.
    if (!is_uniform(claim) || !claim.distances_only) check_at_least_0("tolerance", tolerance);
    check_places(claim);
}

void check_least_radius(const Claim& claim, double least_radius) {
    const double smallest = claim.domain.longer_side() * kSmallestRadius;
    if (least_radius >= smallest) return;
    const std::string found =
        is_uniform(claim) ? "" : "gives a least radius of " + text(least_radius) + ", but it ";
    throw BadRequest(claim.field != nullptr ? "scale" : "radius",
                     text(claim.field != nullptr ? claim.scale : claim.radius),
                     found + "must be at least " + text(smallest) +
                         ", the longer side / 2^32, or doubles run out of digits");
}

void check_longest_ellipse(const Claim& claim, double longest_radius) {
    const double shorter_side = claim.domain.shorter_side();
    constexpr double kSlack = 1 + 1e-12;  // for the rounding of the radius
    if (!claim.domain.wraps() || 2 * longest_radius <= shorter_side * kSlack) return;
    throw BadRequest("torus", "with an ellipse of length " + text(2 * longest_radius),
                     "must be at most the domain's shorter side, " + text(shorter_side));
}

bool is_uniform(const Claim& claim) {
    return claim.field == nullptr && claim.mask == nullptr && claim.places.outlines.empty() &&
           !claim.places.border_by_radius && claim.border == 0 && claim.classes.names.empty();
}

double tolerance_of(const Claim& claim) {
    const double units = neighbours_of(claim).longer_side * 0x1p-28;
    if (!claim.tolerance && !claim.classes.distances.empty()) {
        const std::vector<double> shares = shares_of(claim);
        const std::size_t count = claim.classes.names.size();
        const double coarser = count <= 4 ? 1 : count <= 8 ? 2 : 4;
        return 2 * units * coarser * *std::max_element(shares.begin(), shares.end());
    }
    const bool is_plain = is_uniform(claim) && claim.keep.empty();
    return claim.tolerance.value_or(is_plain ? units : 2 * units);
}

}  // namespace lacuna::verify
