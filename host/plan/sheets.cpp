// Distances and weights of classes in whole numbers, and the checks of both.
#include "plan/sheets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "base/number_text.h"
#include "plan/kept.h"
#include "plan/radius_field.h"

namespace lacuna {
namespace {

// The largest ratio of two distances.
constexpr double kMostRatio = 4000;
constexpr double kMostWeight = 65536;
// A class of a smaller share of the greatest weight counts as one of this share.
constexpr double kLeastShareOfWeight = 1 / kMostWeight;

// The classes' names go into files, and some of these have no quotes.
bool is_name(const std::string& name) {
    return !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
        return c <= ' ' || c == ',' || c == ':' || c == ';' || c == '"' || c == '\'' || c == '<' ||
               c == '>' || c == '&' || c == '/' || c == '\\' || c == 127;
    });
}

void check_names(const Classes& classes) {
    const std::size_t count = classes.names.size();
    if (count > MOST_CLASSES)
        throw BadRequest("class", std::to_string(count) + " classes",
                         "must be at most " + std::to_string(MOST_CLASSES));
    for (auto name = classes.names.begin(); name != classes.names.end(); ++name) {
        if (!is_name(*name))
            throw BadRequest(
                "class", "'" + *name + "'",
                "must be a name without spaces and without , : ; / \\ < > & or quotes");
        if (std::find(classes.names.begin(), name, *name) != name)
            throw BadRequest("class", *name, "is given twice");
    }
}

void check_weights(const Classes& classes) {
    if (classes.weights.empty()) return;
    check_each(classes, "class", classes.weights.size(), " weights");
    for (std::size_t i = 0; i < classes.weights.size(); ++i)
        if (!std::isfinite(classes.weights[i]) || classes.weights[i] < 0)
            throw BadRequest("class", classes.names[i],
                             "its weight is " + shortest(classes.weights[i]) +
                                 ": must be a finite number of at least 0");
    if (std::all_of(classes.weights.begin(), classes.weights.end(),
                    [](double weight) { return weight == 0; }))
        throw BadRequest("class", "all", "have the weight 0: one must be greater");
}

}  // namespace

void check_each(const Classes& classes, const char* option, std::size_t size, const char* what) {
    const std::size_t count = classes.names.size();
    if (size != 0 && size != count)
        throw BadRequest(option, std::to_string(size) + what,
                         "must be one for each of the " + std::to_string(count) + " classes");
}

void check_distances(const Classes& classes) {
    const std::size_t count = classes.names.size();
    const auto pair_of = [&](std::size_t i) {
        const std::string& a = classes.names[i / count];
        const std::string& b = classes.names[i % count];
        return a == b ? a : a + " and " + b;
    };
    const auto refuse = [&](std::size_t i, const std::string& allowed) {
        throw BadRequest("between", pair_of(i), allowed);
    };
    if (classes.distances.size() != count * count)
        throw BadRequest("between",
                         std::to_string(classes.distances.size()) +
                             (classes.distances.size() == 1 ? " distance" : " distances"),
                         "must be a matrix of " + std::to_string(count) + " x " +
                             std::to_string(count) + ", for as many classes");
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    for (std::size_t i = 0; i < count * count; ++i) {
        const double distance = classes.distances[i];
        const bool is_own = i / count == i % count;
        if (!std::isfinite(distance) || distance < 0 || (is_own && distance == 0))
            refuse(i, "keep " + shortest(distance) + ": must be a finite number " +
                          (is_own ? "greater than 0" : "of at least 0"));
        if (distance != classes.distances[i % count * count + i / count])
            refuse(i, "keep " + shortest(distance) + " and " +
                          shortest(classes.distances[i % count * count + i / count]) +
                          ": must be the same both ways");
        if (distance > 0) least = std::min(least, distance);
        greatest = std::max(greatest, distance);
    }
    if (greatest > kMostRatio * least)
        throw BadRequest("between",
                         "distances from " + shortest(least) + " to " + shortest(greatest),
                         "the greatest must be at most " + shortest(kMostRatio) +
                             " times the least that is not 0");
}

namespace {

void check_counts(const Request& request) {
    const Classes& classes = request.classes;
    const std::size_t count = classes.names.size();
    if (classes.counts.empty()) return;
    const auto refuse = [](const std::string& which, const std::string& why) {
        throw BadRequest("class", which, why);
    };
    check_each(classes, "class", classes.counts.size(), " numbers of points");
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<std::uint64_t>& own = classes.counts[i];
        if (!own) continue;
        const std::string which = classes.names[i] + " with " + std::to_string(*own) + " points";
        if (*own == 0) refuse(which, "must have at least 1; the weight 0 lets it have none");
        if (!classes.weights.empty() && classes.weights[i] == 0)
            refuse(which, "is not drawn, as its weight is 0");
        if (count == 1) refuse(which, "is the only class: give a limit instead");
        if (request.count || request.limit || request.progressive)
            refuse(which, "is for sets without --count, --limit and --progressive");
        const Members members(request);
        std::uint64_t kept = 0;
        for (std::size_t k = 0; k < request.keep.size(); ++k)
            if (request.keep_classes[k] == i && members.has(request.keep[k])) ++kept;
        if (kept > *own) refuse(which, "has " + std::to_string(kept) + " kept ones already");
    }
}

// The factor of two classes, from the share of the least distance that they keep: rounded up to a
// multiple of 2^-20 or, if that would make their distance over half a grid unit longer, of 2^-32.
// The first is precise enough for short distances, whose sets were made with it before.
std::uint64_t factor_of(double share, std::uint32_t most_radius) {
    constexpr double kOne = static_cast<double>(FACTOR_ONE);
    const double coarse = std::ceil(share * 0x1p20) * 0x1p-20;
    const bool is_far_off = (coarse - share) * most_radius > 0.5;
    return static_cast<std::uint64_t>(is_far_off ? std::ceil(share * kOne) : coarse * kOne);
}

}  // namespace

Sheets::Sheets() : Sheets(1, std::array{1.0}, std::array{1.0}) {}

Sheets::Sheets(std::uint32_t count, std::span<const double> distances,
               std::span<const double> weights, std::uint32_t most_radius)
    : count_(count), bits_(static_cast<std::uint32_t>(std::bit_width(last_of(count)))) {
    for (std::size_t i = 0; i < distances.size(); ++i)
        factors_[i / count * MOST_CLASSES + i % count] = factor_of(distances[i], most_radius);
    const double greatest = *std::max_element(weights.begin(), weights.end());
    for (const double weight : weights) {
        const double share = std::max(weight / greatest, kLeastShareOfWeight);
        weights_.push_back(
            weight == 0 ? 0 : static_cast<std::uint32_t>(std::lround(share * kMostWeight)));
    }
}

std::uint64_t Sheets::greatest_factor(std::uint32_t sheet) const {
    const auto row = factors().subspan(sheet * std::size_t{MOST_CLASSES}, count_);
    return *std::max_element(row.begin(), row.end());
}

std::uint64_t Sheets::factor_of_boxes(std::uint32_t sheet) const {
    std::uint64_t least = factor(sheet, sheet);
    for (std::uint32_t other = 0; other < count_; ++other)  // at most twice as long
        if (factor(sheet, other) != 0) least = std::min(least, 2 * factor(other, other));
    return least;
}

double least_distance_of(const Classes& classes) {
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : classes.distances)
        if (distance > 0) least = std::min(least, distance);
    return least;
}

double distance_factor(const Request& request, const Result& result) {
    const double size = request.field != nullptr ? result.scale : result.radius;
    return size / least_distance_of(request.classes);
}

std::vector<double> distances_of(const Request& request) {
    if (request.classes.names.empty()) return {1};
    const double least = least_distance_of(request.classes);
    std::vector<double> distances;
    for (const double distance : request.classes.distances) distances.push_back(distance / least);
    return distances;
}

Sheets sheets_of(const Request& request, std::uint32_t most_radius) {
    if (request.classes.names.empty()) return {};
    std::vector<double> weights = request.classes.weights;
    weights.resize(request.classes.names.size(), weights.empty() ? 1.0 : 0.0);
    return {static_cast<std::uint32_t>(weights.size()), distances_of(request), weights,
            most_radius};
}

double border_of(const Request& request, std::size_t of_class) {
    const std::vector<double>& own = request.classes.borders;
    return own.empty() ? request.border : own[of_class];
}

const Mask* mask_of(const Request& request, std::size_t of_class) {
    const std::vector<const Mask*>& own = request.classes.masks;
    return own.empty() || own[of_class] == nullptr ? request.mask : own[of_class];
}

bool has_counts(const Classes& classes) {
    const auto has_one = [](const auto& count) { return count.has_value(); };
    return std::any_of(classes.counts.begin(), classes.counts.end(), has_one);
}

bool has_open_class(const Classes& classes) {
    for (std::size_t i = 0; i < classes.names.size(); ++i)
        if ((classes.weights.empty() || classes.weights[i] > 0) &&
            (classes.counts.empty() || !classes.counts[i]))
            return true;
    return classes.names.empty();
}

bool has_own_places(const Classes& classes) {
    return !classes.borders.empty() || !classes.masks.empty();
}

void check_classes(const Request& request) {
    const Classes& classes = request.classes;
    const std::string mode = "with mode " + std::string(name_of(request.mode));
    if (classes.names.empty()) {
        if (!classes.distances.empty() || !classes.weights.empty() || has_own_places(classes))
            throw BadRequest("between", "distances, weights, borders or masks",
                             "are for classes, which lack names");
        if (!request.keep_classes.empty())
            throw BadRequest("keep", "classes of points", "are for requests with classes");
        return;
    }
    if (request.mode != Mode::exact) throw BadRequest("class", mode, "is for mode exact");
    check_names(classes);
    check_weights(classes);
    check_distances(classes);
    // Without a size of its own the request has the classes' least distance as its radius.
    const double least = least_distance_of(classes);
    const double smallest = request.domain.longer_side() * kSmallestRadius;
    if (request.field == nullptr && !request.count && request.radius.value_or(least) == least &&
        least < smallest)
        throw BadRequest("class", classes.names.front(),
                         "the least distance of two classes is " + shortest(least) +
                             ": must be at least " + shortest(smallest) +
                             ", the longer side / 2^20, or the grid's units run out");
    if (request.keep_classes.size() != request.keep.size())
        throw BadRequest("keep", std::to_string(request.keep.size()) + " points",
                         "with classes each needs a class, but " +
                             std::to_string(request.keep_classes.size()) + " have one");
    for (const std::uint8_t of_point : request.keep_classes)
        if (of_point >= classes.names.size())
            throw BadRequest("keep", "class " + std::to_string(of_point),
                             "must be less than " + std::to_string(classes.names.size()) +
                                 ", the number of classes");
    check_counts(request);
}

namespace {

void check_radii(std::span<const double> radii) {
    for (const double radius : radii)
        if (!(radius > 0) || !std::isfinite(radius))
            throw BadRequest("class", shortest(radius),
                             "a radius must be a finite number greater than 0");
}

}  // namespace

std::vector<double> distances_by_sum(std::span<const double> radii) {
    check_radii(radii);
    std::vector<double> distances;
    for (const double a : radii)
        for (const double b : radii) distances.push_back(a + b);
    return distances;
}

// Wei 2010, as docs/placement.md has it.
std::vector<double> distances_by_union(std::span<const double> radii) {
    check_radii(radii);
    std::vector<double> distances;
    for (const double& a : radii) {
        for (const double& b : radii) {
            double density = 0;  // of all classes that are no denser than the denser one of the two
            for (const double radius : radii)
                if (radius >= std::min(a, b)) density += 1 / (radius * radius);
            distances.push_back(&a == &b ? a : 1 / std::sqrt(density));
        }
    }
    return distances;
}

}  // namespace lacuna
