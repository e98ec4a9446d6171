// How many samples and how much memory mode exact with a radius field needs, and at which size it
// has a number of samples (docs/design.md, section 5).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "checks/classes.h"
#include "plan/checked_request.h"
#include "plan/class_copies.h"
#include "plan/mask_tree.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

// The pixels on which a stretch of a mask's side lies, and how much of it lies on each. Positions
// are in pixels of the mask, of which its side has `count`.
std::vector<std::pair<std::size_t, double>> pixels_under(std::size_t first, std::size_t end,
                                                         std::size_t count, std::size_t pixels) {
    const auto at = [&](std::size_t pixel) {
        return static_cast<double>(pixel * count) / static_cast<double>(pixels);
    };
    std::vector<std::pair<std::size_t, double>> found;
    for (std::size_t pixel = first * pixels / count; pixel * count < end * pixels; ++pixel)
        found.emplace_back(pixel, std::min(static_cast<double>(end), at(pixel + 1)) -
                                      std::max(static_cast<double>(first), at(pixel)));
    return found;
}

// The integral of the importance where the mask allows samples, over that of the greatest
// importance everywhere.
double exact_share(const Mask& mask, const Field& field, double greatest, const Poll& poll) {
    double sum = 0;
    const auto add = [&](std::size_t left, std::size_t top, std::size_t columns, std::size_t rows) {
        ask_after(1);
        const auto across = pixels_under(left, left + columns, mask.columns, field.columns);
        for (const auto& [down, height] : pixels_under(top, top + rows, mask.rows, field.rows))
            for (const auto& [right, width] : across)
                sum += height * width * field.importance[down * field.columns + right] / greatest;
    };
    if (mask.drawn)
        mask.drawn->tree.for_each_allowed(
            [&](std::uint32_t column, std::uint32_t row, std::uint32_t columns,
                std::uint32_t rows) { add(column, mask.rows - row - rows, columns, rows); });
    for_each_polled(mask.allowed.size(), poll, [&](std::size_t i) {
        if (mask.allowed[i] != 0) add(i % mask.columns, i / mask.columns, 1, 1);
    });
    return sum / mask.columns / mask.rows;
}

// The integral of the importance where samples of a class may lie, as a fraction of a domain that
// has the greatest importance everywhere.
double share_of(const Request& request, std::size_t of_class, double greatest, const Poll& poll) {
    const Field* const field = request.field;
    const Mask* const mask = mask_of(request, of_class);
    const double border = border_of(request, of_class);
    const double inside = (request.domain.width - 2 * border) / request.domain.width *
                          (request.domain.height - 2 * border) / request.domain.height;
    double sum = 0;
    if (mask == nullptr) {
        if (field == nullptr) return inside;
        for_each_polled(field->importance.size(), poll,
                        [&](std::size_t i) { sum += field->importance[i] / greatest; });
        return inside * sum / static_cast<double>(field->importance.size());
    }
    if (mask->drawn && field == nullptr) return inside * mask->drawn->tree.allowed_share();
    const auto middle_in = [](std::size_t i, std::size_t count, std::size_t pixels) {
        return (2 * i + 1) * pixels / (2 * count);
    };
    if (mask->drawn) return inside * exact_share(*mask, *field, greatest, poll);
    // For each pixel of a grid, mask and importance at its middle are taken.
    const auto share_on = [&](std::size_t columns, std::size_t rows) {
        sum = 0;
        const auto add_row = [&](std::size_t row) {
            const std::uint8_t* const allowed =
                &mask->allowed[middle_in(row, rows, mask->rows) * mask->columns];
            const double* const importance =
                field == nullptr
                    ? nullptr
                    : &field->importance[middle_in(row, rows, field->rows) * field->columns];
            for (std::size_t i = 0; i < columns; ++i) {
                if (allowed[middle_in(i, columns, mask->columns)] == 0) continue;
                sum += importance == nullptr
                           ? 1
                           : importance[middle_in(i, columns, field->columns)] / greatest;
            }
        };
        for_each_polled(rows, poll, add_row, columns);
        return inside * sum / (static_cast<double>(columns) * static_cast<double>(rows));
    };
    const double share = share_on(mask->columns, mask->rows);
    if (share > 0 || field == nullptr) return share;
    // The field may be 0 at the middles of all pixels of the mask.
    return inside * exact_share(*mask, *field, greatest, poll);
}

double greatest_of(const Request& request) {
    if (request.field == nullptr) return 1;
    double greatest = 0;
    for_each_polled(request.field->importance.size(), ask, [&](std::size_t i) {
        greatest = std::max(greatest, request.field->importance[i]);
    });
    return greatest;
}

// The memory that all classes take, over that of one class that keeps the least distance. It grows
// with the number of first boxes, which are short on every copy on which samples of a dense class
// are seen.
double crowd_of_boxes(const Request& request) {
    const ClassCopies copies = copies_of(request);
    double crowd = 0;
    for (std::uint32_t copy = 0; copy < copies.count(); ++copy) {
        const double length = static_cast<double>(copies.factor_of_boxes(copy)) / FACTOR_ONE;
        if (copies.weight(copy) != 0) crowd += 1 / (length * length);
    }
    return crowd;
}

// `samples` is the number that a class of the least distance has where it is alone.
void check_size(const Request& request, const std::string& option, const std::string& value,
                double least_radius, double samples) {
    constexpr double kBytesPerSample = 250, kBytesPerPixel = 12, kBytesPerMaskPixel = 4. / 3,
                     kBytesPerBox = 50;
    constexpr double kBytesPerEllipse = sizeof(portable::Ellipse);
    const double longer = request.domain.longer_side();
    if (!(least_radius >= longer * kSmallestRadius))
        throw BadRequest(option, value,
                         "makes the least radius " + shortest(least_radius) +
                             ": it must be at least " + shortest(longer * kSmallestRadius) +
                             ", the longer side / 2^20, or the grid's units run out");
    double bytes = samples * crowd_of_boxes(request) * kBytesPerSample;
    // Boxes of a class are cut along a mask of its own, down to the slots of the tree.
    const bool are_alike = !has_own_places(request.places);
    const double boxes_of_pixel = are_alike ? 0 : kBytesPerBox;
    for (std::size_t i = 0; i < (are_alike ? 1 : request.classes.names.size()); ++i) {
        if (request.field != nullptr)
            bytes += static_cast<double>(request.field->importance.size()) * kBytesPerPixel +
                     static_cast<double>(request.field->stretches.size()) * kBytesPerEllipse;
        const Mask* const mask = mask_of(request, i);
        if (mask == nullptr) continue;
        bytes += static_cast<double>(mask->allowed.size()) * (kBytesPerMaskPixel + boxes_of_pixel);
        if (mask->drawn)
            bytes += static_cast<double>(mask->drawn->tree.nodes().size()) *
                     (sizeof(MaskTree::Node) + MaskTree::kSlots * boxes_of_pixel);
    }
    refuse_more_memory(request, option, value, bytes);
}

// The expected number of samples in all classes, if each were alone, over the number of a class
// that keeps the least distance.
double crowd_of(const Request& request) {
    const std::vector<double> distances = distances_of(request.classes);
    const std::size_t count = std::max<std::size_t>(request.classes.names.size(), 1);
    double crowd = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double own = distances[i * (count + 1)];
        if (request.classes.weights.empty() || request.classes.weights[i] > 0)
            crowd += 1 / (own * own);
    }
    return crowd;
}

// The same share for all classes together: the mean of theirs, in proportion to their samples.
double share_of(const Request& request, double greatest, const Poll& poll) {
    if (!has_own_places(request.places)) return share_of(request, 0, greatest, poll);
    const std::vector<double> distances = distances_of(request.classes);
    const std::size_t count = request.classes.names.size();
    double samples = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double own = distances[i * (count + 1)];
        if (request.classes.weights.empty() || request.classes.weights[i] > 0)
            samples += share_of(request, i, greatest, poll) / (own * own);
    }
    const double crowd = crowd_of(request);
    return crowd == 0 ? 0 : samples / crowd;
}

}  // namespace

double radius_field_scale_for_count(const Request& request, double count, const Poll& poll) {
    const double greatest = greatest_of(request);
    const double share = share_of(request, greatest, poll);
    if (request.count && share == 0)
        throw BadRequest("count", std::to_string(*request.count),
                         "has no room: the field is 0 where the mask allows samples");
    // Limit for an importance so low that a single sample covers the whole domain.
    const double most = 2 * std::hypot(request.domain.width, request.domain.height);
    const double radius = std::min(most, std::sqrt(kTorusDensity * share * request.domain.width *
                                                   request.domain.height / count));
    const double size = radius * std::sqrt(greatest) * std::sqrt(crowd_of(request));
    // Small islands have more points than the formula says. So if it asks for a little less than
    // the least radius, that one is tried.
    constexpr double kLittle = 0.8;
    const double least = request.domain.longer_side() * kSmallestRadius * std::sqrt(greatest);
    return size > kLittle * least ? std::max(size, least) : size;
}

FieldSize check_radius_field_size(const Request& request, double size, const Poll& poll) {
    const std::string option = request.count              ? "count"
                               : request.field != nullptr ? "scale"
                                                          : "radius";
    const std::string value = request.count ? std::to_string(*request.count) : shortest(size);
    if (!std::isfinite(size) || size <= 0)
        throw BadRequest(option, value, "must be a finite number greater than 0");
    const double greatest = greatest_of(request);
    const double least_radius = size / std::sqrt(greatest);
    const double samples = kTorusDensity * share_of(request, greatest, poll) *
                           (request.domain.width / least_radius) *
                           (request.domain.height / least_radius);
    check_size(request, option, value, least_radius, samples);
    return {least_radius, samples * crowd_of(request)};
}

double least_pixel_step(const Raster& raster, const Domain& domain) {
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](std::uint32_t pixels, double side, const auto& at) {
        for (std::uint32_t i = 1; i < pixels; ++i) least = std::min(least, at(i) - at(i - 1));
        if (pixels > 1 && domain.wraps()) least = std::min(least, side - (at(pixels - 1) - at(0)));
    };
    const auto way = [&](std::uint32_t x, std::uint32_t y) {
        return domain.from_corner(raster.centre(x, y, domain));
    };
    look(raster.columns, domain.width, [&](std::uint32_t i) { return way(i, 0).x; });
    look(raster.rows, domain.height, [&](std::uint32_t i) { return way(0, i).y; });
    return std::isinf(least) ? 0 : least;
}

}  // namespace lacuna
