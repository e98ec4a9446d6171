// Requests of classes as nobody would ask for them, and a judge of their sets that computes as a
// user would, pair by pair.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "backends/radius_field_requests.h"
#include "sample/distance.h"

namespace lacuna::tests {

using Random = std::mt19937_64;

inline double share(Random& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

inline Request request_of(std::vector<double> distances, std::vector<double> weights = {}) {
    Request request;
    const auto count = static_cast<std::size_t>(std::lround(std::sqrt(distances.size())));
    for (std::size_t i = 0; i < count; ++i)
        request.classes.names.push_back("class-" + std::to_string(i));
    request.classes.distances = std::move(distances);
    request.classes.weights = std::move(weights);
    request.place.backend = "cpu";
    return request;
}

class JudgeOfClasses {
public:
    JudgeOfClasses(const Request& request, const Result& result)
        : request_(request), result_(result) {
        for (std::size_t i = 0; i < result.points.size(); ++i)
            sizes_.push_back(size_at(result.points[i], result.classes[i]));
    }

    double distance(Point a, Point b) const { return distance_on(request_.domain, a, b); }
    // What a distance at importance 1 becomes at a spot; nothing where no point of a class may lie.
    std::optional<double> size_at(Point p, std::size_t kind) const {
        const Mask* mask = request_.mask;
        if (!request_.classes.masks.empty() && request_.classes.masks[kind] != nullptr)
            mask = request_.classes.masks[kind];
        if (mask != nullptr && value_at(*mask, mask->allowed, p) == 0) return std::nullopt;
        const double border =
            request_.classes.borders.empty() ? request_.border : request_.classes.borders[kind];
        if (std::min({p.x, p.y, request_.domain.width - p.x, request_.domain.height - p.y}) <
            border)
            return std::nullopt;
        if (request_.field == nullptr) return 1;
        const double importance = value_at(*request_.field, request_.field->importance, p);
        if (importance == 0) return std::nullopt;
        return 1 / std::sqrt(importance);
    }
    double limit(std::size_t a, std::size_t b) const {
        return request_.classes.distances[a * request_.classes.names.size() + b];
    }

    // The first point that lies where none may.
    std::string astray() const {
        for (std::size_t i = 0; i < sizes_.size(); ++i)
            if (!sizes_[i]) return std::to_string(i);
        return "";
    }
    // The first two points that are too close, if there are any.
    std::string conflict() const {
        for (std::size_t i = 0; i < result_.points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double least = limit(result_.classes[i], result_.classes[j]) *
                                     std::min(sizes_[i].value_or(0), sizes_[j].value_or(0));
                if (distance(result_.points[i], result_.points[j]) < least)
                    return std::to_string(j) + " and " + std::to_string(i);
            }
        return "";
    }
    bool has_room(Point spot, std::size_t kind, double tolerance) const {
        const std::optional<double> size = size_at(spot, kind);
        if (!size) return false;
        for (std::size_t i = 0; i < result_.points.size(); ++i) {
            const double least =
                limit(result_.classes[i], kind) * std::min(*size, sizes_[i].value_or(0));
            if (distance(spot, result_.points[i]) < least + tolerance && least > 0) return false;
        }
        return true;
    }
    // Spots at random at which a point of some class has room.
    int gaps(Random& random, int spots) const {
        const std::vector<double>& weights = request_.classes.weights;
        int gaps = 0;
        for (int k = 0; k < spots; ++k) {
            const Point spot{share(random) * request_.domain.width,
                             share(random) * request_.domain.height};
            for (std::size_t kind = 0; kind < request_.classes.names.size(); ++kind)
                if (weights.empty() || weights[kind] != 0) gaps += has_room(spot, kind, 1e-6);
        }
        return gaps;
    }

private:
    template <typename Pixels, typename Values>
    double value_at(const Pixels& pixels, const Values& values, Point p) const {
        const auto along = [](double at, std::uint32_t count) {
            return static_cast<std::uint32_t>(std::clamp(std::floor(at * count), 0.0, count - 1.0));
        };
        const std::uint32_t column = along(p.x / request_.domain.width, pixels.columns);
        const std::uint32_t row =
            pixels.rows - 1 - along(p.y / request_.domain.height, pixels.rows);
        return static_cast<double>(values[std::size_t{row} * pixels.columns + column]);
    }

    const Request& request_;
    const Result& result_;
    std::vector<std::optional<double>> sizes_;
};

// Classes as nobody would ask for them: two to sixteen, with distances up to a thousand times the
// least, classes that ignore each other or leave each other no room, and weights of 0.
inline FieldRequest hostile_request(Random& random) {
    FieldRequest made;
    Request& request = made.request;
    const std::size_t count = 2 + random() % (random() % 3 == 0 ? 15 : 3);
    const double ratio = random() % 4 == 0 ? 1000 : 8;
    std::vector<double> radii;
    for (std::size_t i = 0; i < count; ++i) radii.push_back(0.03 * std::pow(ratio, share(random)));
    std::vector<double> distances =
        random() % 2 == 0 ? distances_by_sum(radii) : distances_by_union(radii);
    if (random() % 3 == 0)
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                const bool is_unknown = i != j && random() % 4 == 0;
                distances[i * count + j] = distances[j * count + i] =
                    is_unknown ? 0 : 0.02 * std::pow(ratio, share(random));
            }
    std::vector<double> weights(count, 1);
    if (random() % 3 == 0)
        for (std::size_t i = 1; i < count; ++i) weights[i] = random() % 4 == 0 ? 0 : share(random);
    request = request_of(std::move(distances), std::move(weights));
    request.seed = random();
    request.domain.boundary = random() % 2 == 0 ? Boundary::torus : Boundary::box;
    if (random() % 2 == 0) request.domain.width = 1.7;
    const auto side = [&] { return 1 + static_cast<std::uint32_t>(random() % 6); };
    if (random() % 3 == 0) {
        Field field{side(), side(), {}};
        for (std::size_t i = 0; i < std::size_t{field.columns} * field.rows; ++i)
            field.importance.push_back(random() % 7 == 0 ? 0 : std::pow(100, share(random) - 0.7));
        field.importance.front() = 1;
        made.field = std::make_shared<const Field>(std::move(field));
        request.field = made.field.get();
    }
    if (random() % 3 == 0) {
        made.mask = std::make_shared<const Mask>(noise_mask(side(), side(), random()));
        request.mask = made.mask.get();
    }
    const double half = request.domain.shorter_side() / 2;
    const bool is_torus = request.domain.wraps();
    if (random() % 6 == 0) request.border = is_torus ? 0 : half * share(random);
    if (random() % 3 != 0) return made;
    for (std::size_t i = 0; i < count; ++i) {
        const double border = random() % 3 == 0 ? 0.999 * half : half / 2 * share(random);
        request.classes.borders.push_back(is_torus || random() % 3 == 0 ? 0 : border);
        if (random() % 2 == 0)
            made.masks.push_back(
                std::make_shared<const Mask>(noise_mask(side(), side(), random())));
        request.classes.masks.push_back(
            random() % 2 == 0 || made.masks.empty() ? nullptr : made.masks.back().get());
    }
    if (random() % 4 == 0) request.classes.masks.clear();
    return made;
}

}  // namespace lacuna::tests
