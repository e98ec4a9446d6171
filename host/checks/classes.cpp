// Questions about classes of points, and their checks.
#include "checks/classes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "base/number_text.h"

namespace lacuna {

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
    }
}

void check_classes_of_points(const Classes& classes, const char* option, std::size_t points,
                             std::span<const std::uint8_t> of_points) {
    if (of_points.size() != points)
        throw BadRequest(option, std::to_string(points) + " points",
                         "with classes each needs a class, but " +
                             std::to_string(of_points.size()) + " have one");
    for (const std::uint8_t own : of_points)
        if (own >= classes.names.size())
            throw BadRequest(
                option, (option == std::string_view("class") ? "" : "class ") + std::to_string(own),
                "must be less than " + std::to_string(classes.names.size()) +
                    ", the number of classes");
}

void check_priority(const Classes& classes) {
    if (!classes.by_priority) return;
    if (classes.names.empty())
        throw BadRequest("priority", "without classes", "is the order of classes");
    for (std::size_t i = 0; i < classes.weights.size(); ++i)
        if (classes.weights[i] != 0 && classes.weights[i] != 1)
            throw BadRequest(
                "priority",
                "with class " + classes.names[i] + " of weight " + shortest(classes.weights[i]),
                "each class is full before the next begins: give no weight, or 0");
}

double own_distance_of(const Classes& classes, std::size_t of_class) {
    return classes.distances[of_class * (classes.names.size() + 1)];
}

double least_distance_of(const Classes& classes) {
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : classes.distances)
        if (distance > 0) least = std::min(least, distance);
    return least;
}

void take_size_of_classes(Request& request) {
    std::optional<double>& size = request.field != nullptr ? request.scale : request.radius;
    if (request.classes.names.empty() || request.count || size) return;
    size = least_distance_of(request.classes);
}

double size_of(const Claim& claim) {
    const double size = claim.field != nullptr ? claim.scale : claim.radius;
    return size > 0 || claim.classes.names.empty() ? size : least_distance_of(claim.classes);
}

double distance_factor(const Request& request, const Result& result) {
    const double size = request.field != nullptr ? result.scale : result.radius;
    return size / least_distance_of(request.classes);
}

std::vector<double> distances_of(const Classes& classes) {
    if (classes.names.empty()) return {1};
    const double least = least_distance_of(classes);
    std::vector<double> distances;
    for (const double distance : classes.distances) distances.push_back(distance / least);
    return distances;
}

double greatest_share(const Classes& classes) {
    const std::vector<double> shares = distances_of(classes);
    return *std::max_element(shares.begin(), shares.end());
}

double border_of(const Request& request, std::size_t of_class) {
    const std::vector<double>& own = request.places.borders;
    return own.empty() ? request.places.border : own[of_class];
}

const Mask* mask_of(const Request& request, std::size_t of_class) {
    const std::vector<const Mask*>& own = request.places.masks;
    return own.empty() || own[of_class] == nullptr ? request.places.mask : own[of_class];
}

bool has_counts(const Classes& classes) {
    const auto has_one = [](const auto& count) { return count.has_value(); };
    return std::any_of(classes.counts.begin(), classes.counts.end(), has_one);
}

bool has_stages(const Classes& classes) {
    return has_counts(classes) || (classes.by_priority && classes.names.size() > 1);
}

bool is_open(const Classes& classes, std::size_t of_class) {
    return (classes.weights.empty() || classes.weights[of_class] > 0) &&
           (classes.counts.empty() || !classes.counts[of_class]);
}

KindOfClass kind_of(const Classes& classes, std::size_t of_class) {
    KindOfClass kind{of_class, of_class};
    const std::string& name = classes.names[of_class];
    while (kind.first > 0 && classes.names[kind.first - 1] == name) --kind.first;
    while (kind.last + 1 < classes.names.size() && classes.names[kind.last + 1] == name)
        ++kind.last;
    return kind;
}

bool has_sizes(const Classes& classes) {
    return std::adjacent_find(classes.names.begin(), classes.names.end()) != classes.names.end();
}

bool has_open_class(const Classes& classes) {
    for (std::size_t i = 0; i < classes.names.size(); ++i)
        if (is_open(classes, i)) return true;
    return classes.names.empty();
}

bool has_own_places(const Places& places) {
    const auto is_own = [](const Outline& outline) { return !outline.of_class.empty(); };
    return !places.borders.empty() || !places.masks.empty() ||
           std::any_of(places.outlines.begin(), places.outlines.end(), is_own);
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
