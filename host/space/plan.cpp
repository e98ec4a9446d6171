// Checks requests in space, and turns them into plans.
#include "space/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/polling.h"
#include "checks/numbers.h"
#include "checks/space.h"
#include "plan/sizes.h"
#include "rounds/round_policy.h"
#include "space/vectors.h"

namespace lacuna::space {
namespace {

constexpr double kUnits = 0x1p30;            // along the longest side
constexpr double kSmallestRadius = 0x1p-20;  // of the longest side
constexpr double kFarthest = 0x1p18;         // from the origin, in longest sides
constexpr double kRounding = 1 + 0x1p-50;    // of a distance that a user computes
constexpr double kVolumeDensity = 0.7336;    // N r^3 over the volume, on a torus
// Measured: the memory that runs took, less the mesh, was 430 to 480 bytes for each point of
// spheres and 920 of a volume. Where triangles are small it was 60 bytes for each triangle.
constexpr double kBytesOfPointOnSurface = 500;
constexpr double kBytesOfPointInVolume = 1000;
constexpr double kBytesOfTriangle = 64;
constexpr double kBytesOfPiece = 200;  // of a thin triangle, a radius long

}  // namespace

CheckedRequest::CheckedRequest(const SpaceRequest& request) : request_(&request) {
    if (request.radius.has_value() == request.count.has_value())
        throw BadRequest("radius", request.radius ? "with a count" : "missing",
                         "give either a radius or a count");
    if (request.radius) check_positive("radius", *request.radius);
    if (request.count && *request.count == 0) throw BadRequest("count", "0", "must be at least 1");
    if (request.limit && *request.limit == 0) throw BadRequest("limit", "0", "must be at least 1");
    if (request.count && *request.count < request.keep.size())
        throw BadRequest("count", std::to_string(*request.count),
                         "must be at least " + std::to_string(request.keep.size()) +
                             ", the number of kept points, which count");
    if (request.round_size > kLargestRoundInExact)
        throw BadRequest("round-size", std::to_string(request.round_size),
                         "must be at most " + std::to_string(kLargestRoundInExact));
    check_threads(request.run_on.threads);
    if (request.mesh != nullptr)
        find_units_of_mesh();
    else
        find_units_of_volume();
    check_keep();
}

void CheckedRequest::find_units_of_mesh() {
    const Mesh& mesh = *request_->mesh;
    check_mesh(mesh);
    const std::span<const std::uint8_t> allowed = request_->allowed;
    if (!allowed.empty() && allowed.size() != mesh.triangles.size())
        throw BadRequest(
            "allowed", std::to_string(allowed.size()) + " values",
            "must be one for each of the " + std::to_string(mesh.triangles.size()) + " triangles");
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Point3 least{kFar, kFar, kFar}, most{-kFar, -kFar, -kFar};
    double farthest = 0;
    for_each_polled(mesh.triangles.size(), ask, [&](std::size_t i) {
        if (!allowed.empty() && allowed[i] == 0) return;
        for (const std::uint32_t vertex : mesh.triangles[i]) {
            const auto& [x, y, z] = mesh.vertices[vertex];
            least = {std::min(least.x, x), std::min(least.y, y), std::min(least.z, z)};
            most = {std::max(most.x, x), std::max(most.y, y), std::max(most.z, z)};
            farthest = std::max({farthest, std::abs(x), std::abs(y), std::abs(z)});
        }
    });
    if (!(least.x <= most.x))
        throw BadRequest("allowed", "no triangle", "points must be allowed on one at least");
    double longest = std::max({most.x - least.x, most.y - least.y, most.z - least.z});
    if (!(longest <= 1e100))
        throw BadRequest("mesh", "that is " + shortest(longest) + " long",
                         "must be at most 1e100 long");
    if (farthest > kFarthest * std::max(longest, 1e-100))
        throw BadRequest("mesh", "that is " + shortest(longest) + " long",
                         "lies up to " + shortest(farthest) +
                             " from 0, more than 2^18 times its length, or doubles run out of "
                             "digits: move it");
    if (longest == 0) longest = 1;
    const double unit = longest / kUnits;
    units_ = {least, {unit, unit, unit}};
    const Position far = units_.position_of(most);
    sides_ = {far.x, far.y, far.z};
    // Sums of doubles in the order of the triangles.
    for_each_polled(mesh.triangles.size(), ask, [&](std::size_t i) {
        if (!allowed.empty() && allowed[i] == 0) return;
        const auto corners = corners_of(mesh, i);
        measure_ += area_of(corners);
        edges_ += std::max({length_of(corners[1] - corners[0]), length_of(corners[2] - corners[1]),
                            length_of(corners[0] - corners[2])});
    });
    if (request_->count && !(measure_ > 0))
        throw BadRequest("count", std::to_string(*request_->count),
                         "the mesh has no area: give a radius");
    lost_ = 0x1p-51 * (longest + farthest);
}

void CheckedRequest::find_units_of_volume() {
    const Volume& volume = request_->volume;
    check_volume(volume);
    if (!request_->allowed.empty())
        throw BadRequest("allowed", "for a volume", "is for the triangles of a mesh");
    const double longest = std::max({volume.width, volume.height, volume.depth});
    const auto units_along = [&](double side) {
        return std::max(1.0, std::floor(side / (longest / kUnits)));
    };
    const double x = units_along(volume.width), y = units_along(volume.height),
                 z = units_along(volume.depth);
    units_ = {{0, 0, 0}, {volume.width / x, volume.height / y, volume.depth / z}};
    sides_ = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
              static_cast<std::int32_t>(z)};
    measure_ = volume.width * volume.height * volume.depth;
    lost_ = 0x1p-51 * longest;
    if (wraps() && request_->radius && *request_->radius > largest_radius())
        throw BadRequest(
            "radius", shortest(*request_->radius),
            "must be at most the shortest side of a torus, " + shortest(largest_radius()));
}

void CheckedRequest::check_keep() const {
    check_points(request_->keep, "keep");
    for_each_polled(request_->keep.size(), ask, [&](std::size_t i) {
        const Point3& point = request_->keep[i];
        // Points that others have rounded to the surface may lie beside the box around it.
        const double slack = request_->mesh == nullptr ? 0 : 2;
        const auto is_in = [&](double at, double low, double unit, std::int32_t side) {
            const double steps = (at - low) / unit;
            return steps >= -slack && (wraps() ? steps < side : steps <= side + slack);
        };
        if (!is_in(point.x, units_.low.x, units_.unit.x, sides_[0]) ||
            !is_in(point.y, units_.low.y, units_.unit.y, sides_[1]) ||
            !is_in(point.z, units_.low.z, units_.unit.z, sides_[2]))
            throw BadRequest("keep", "point " + std::to_string(i),
                             request_->mesh == nullptr ? "lies outside of the volume"
                                                       : "lies outside of the box around the mesh");
    });
}

double CheckedRequest::smallest_radius() const {
    return kSmallestRadius * kUnits * std::max({units_.unit.x, units_.unit.y, units_.unit.z});
}

double CheckedRequest::largest_radius() const {
    const Volume& volume = request_->volume;
    if (wraps()) return std::min({volume.width, volume.height, volume.depth});
    return 2 * kUnits * units_.unit.x;  // more than any distance
}

double CheckedRequest::expected(double radius) const {
    if (request_->mesh != nullptr) return 1 + kTorusDensity * measure_ / (radius * radius);
    if (wraps()) return kVolumeDensity * measure_ / (radius * radius * radius);
    const Volume& volume = request_->volume;  // as if it were larger by most of a radius
    return kVolumeDensity * (volume.width / radius + 0.8) * (volume.height / radius + 0.8) *
           (volume.depth / radius + 0.8);
}

double CheckedRequest::radius_expecting(double count) const {
    double least = smallest_radius(), most = largest_radius();
    for (int i = 0; i < 64; ++i) {
        const double middle = std::sqrt(least * most);
        (expected(middle) > count ? least : most) = middle;
    }
    return least;
}

Plan CheckedRequest::plan(double radius, std::uint64_t most) const {
    const SpaceRequest& request = *request_;
    const std::string option = request.count ? "count" : "radius";
    const std::string value = request.count ? std::to_string(*request.count) : shortest(radius);
    if (!(radius >= smallest_radius()))
        throw BadRequest(option, value,
                         (request.count ? "needs a radius of " + shortest(radius) + ": it " : "") +
                             "must be at least " + shortest(smallest_radius()) +
                             ", the longest side / 2^20");
    const double points = expected(radius);
    const double bytes =
        request.mesh == nullptr
            ? points * kBytesOfPointInVolume
            : points * kBytesOfPointOnSurface +
                  static_cast<double>(request.mesh->triangles.size()) * kBytesOfTriangle +
                  edges_ / radius * kBytesOfPiece;
    refuse_more_memory(Request{.run_on = request.run_on}, option, value, bytes);
    // Blocks near each other, and bins, have 32-bit numbers: up to 31 and 15 for each point.
    const int most_bits = request.mesh != nullptr ? 27 : 28;
    if (points > std::ldexp(1.0, most_bits))
        throw BadRequest(option, value,
                         "would make more than 2^" + std::to_string(most_bits) + " points");

    Plan plan;
    const double unit = std::min({units_.unit.x, units_.unit.y, units_.unit.z});
    const double in_units = std::ceil((radius * kRounding + lost_) / unit);
    // Kept points are rounded to units, too, by less than two units.
    const double of_kept = request.keep.empty() ? 0 : 2;
    plan.radius = static_cast<std::uint32_t>(std::min(in_units + of_kept, 0x1p31));
    plan.radius_squared = std::uint64_t{plan.radius} * plan.radius;
    plan.seed = request.seed;
    plan.round_size = request.round_size;
    plan.user_radius = radius;
    std::vector<Position> kept;
    for (const Point3& point : request.keep) {
        Position position = units_.position_of(point);
        const std::int32_t last = request.mesh == nullptr ? 1 : 0;
        position = {std::clamp(position.x, 0, sides_[0] - last),
                    std::clamp(position.y, 0, sides_[1] - last),
                    std::clamp(position.z, 0, sides_[2] - last)};
        kept.push_back(position);
    }
    plan.of_mode = SpacePlan{std::make_shared<const FirstBins>(
        request.mesh == nullptr
            ? bins_of_volume(sides_, wraps(), plan.radius, kept)
            : bins_of_surface(*request.mesh, request.allowed, units_, plan.radius, kept))};
    const std::uint64_t members = kept.size();
    plan.limit = most > members ? most - members : 0;
    plan.maximal_samples = static_cast<std::uint64_t>(points);
    plan.expected_samples = std::min(plan.maximal_samples, plan.limit);
    return plan;
}

}  // namespace lacuna::space
