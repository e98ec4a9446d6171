// lacuna::sample_surface and sample_volume: from a request to points in space.
#include <lacuna/space.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "backends/backends.h"
#include "base/asked.h"
#include "base/number_text.h"
#include "base/polling.h"
#include "checks/space.h"
#include "plan/sizes.h"
#include "sampling/generate.h"
#include "space/backends.h"
#include "space/plan.h"
#include "space/reference.h"
#include "space/samples.h"
#include "space/vectors.h"

namespace lacuna {
namespace space {
namespace {

// Refuses kept points that are closer than the radius by more than rounding to units, of up to two
// units, explains.
void check_kept_distances(const CheckedRequest& request, const Plan& plan) {
    const FirstBins& all = *plan.space().first_bins;
    const Samples samples(all, plan.radius_squared);
    std::vector<Position> near;
    const double radius = plan.user_radius;
    const auto& [x_unit, y_unit, z_unit] = request.units().unit;
    const double least = radius * (1 - 1e-9) - 2 * std::max({x_unit, y_unit, z_unit});
    for (std::uint32_t block = 0; block < all.blocks(); ++block) {
        if (all.kept_begins[block] == all.kept_begins[block + 1]) continue;
        ask_after();
        samples.find_near(block, near);
        for (std::uint32_t i = all.kept_begins[block]; i < all.kept_begins[block + 1]; ++i) {
            int close = -1;  // the sample itself
            for (const Position& other : near) {
                const Point3 a = request.units().to_user(all.kept[i]);
                const Point3 b = request.units().to_user(other);
                const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
                close += std::sqrt(x * x + y * y + z * z) < least ? 1 : 0;
            }
            if (close > 0)
                throw BadRequest("keep", "points that are closer than " + shortest(radius),
                                 request->count ? "must keep from each other the radius that the "
                                                  "count needs: leave some out, or give a radius"
                                                : "must keep the radius from each other");
        }
    }
}

void append(const CheckedRequest& request, const Plan& plan,
            const std::vector<SpaceSample>& samples, SpaceResult& result) {
    const FirstBins& all = *plan.space().first_bins;
    for_each_polled(samples.size(), ask, [&](std::size_t i) {
        const auto& [at, triangle, u, v] = samples[i];
        result.points.push_back(request.units().to_user(at));
        if (all.is_volume()) return;
        result.triangles.push_back(all.numbers[triangle]);
        double second = u * 0x1p-31, third = v * 0x1p-31;
        if (!all.cut_from.empty()) {
            const auto& [a, b, c] = all.cut_from[triangle];
            const double p = a[0] + second * (b[0] - a[0]) + third * (c[0] - a[0]);
            const double q = a[1] + second * (b[1] - a[1]) + third * (c[1] - a[1]);
            second = p;
            third = q;
        }
        result.shares.push_back({1 - second - third, second, third});
    });
}

// The first `most` points of a maximal set.
SpaceResult sample_at(const CheckedRequest& request, double radius, std::uint64_t most,
                      Observer& observer) {
    const Plan plan = request.plan(radius, most);
    check_kept_distances(request, plan);
    SpaceResult result{.radius = radius};
    result.backend = backend_named(request->run_on);
    const std::unique_ptr<SpaceBackend> backend =
        make_backend(result.backend, plan, request->run_on, observer);
    OutcomeOf<SpaceSample> outcome;
    if (backend == nullptr) {
        outcome = reference_samples(plan, observer);
        result.device = "1 thread";
    } else {
        std::vector<SpaceSample> all;
        all.reserve(plan.expected_samples);
        outcome = generate<SpaceSample>(plan, *backend, observer,
                                        [&](std::span<const SpaceSample> samples) {
                                            all.insert(all.end(), samples.begin(), samples.end());
                                        });
        outcome.samples = std::move(all);
        result.device = backend->device();
    }
    result.maximal = !outcome.is_cut;
    result.rounds = outcome.rounds;
    result.draws = outcome.draws;
    const auto members =
        static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(request->keep.size(), most));
    result.points.reserve(request->keep.size() + outcome.samples.size());
    result.points.assign(request->keep.begin(), request->keep.begin() + members);
    append(request, plan, outcome.samples, result);
    return result;
}

void cut(SpaceResult& result, std::size_t kept, std::uint64_t most) {
    if (result.points.size() <= most) return;
    result.points.resize(most);
    result.maximal = false;
    if (result.triangles.empty()) return;
    result.triangles.resize(most - std::min<std::uint64_t>(kept, most));
    result.shares.resize(result.triangles.size());
}

// A count: the first points of a maximal set that has somewhat more. Where a surface is curved,
// thin or small for the radius, other numbers find room than are expected: then the radius lies
// between one at which there were too few and one at which there were far too many.
SpaceResult sample_count(const CheckedRequest& request, Observer& observer) {
    constexpr double kDeviations = 4 * kCountDeviation;
    constexpr double kNarrow = 1.001;
    const std::uint64_t count = *request->count;
    const double aim =
        static_cast<double>(count) + kDeviations * std::sqrt(static_cast<double>(count)) + 1;
    const auto too_many = static_cast<std::uint64_t>(1.5 * aim) + 8;
    double few = 0, many = 0;  // radii; 0: not known
    for (double radius = request.radius_expecting(aim);;) {
        SpaceResult result = sample_at(request, radius, too_many, observer);
        const std::size_t found = result.points.size();
        const bool is_largest = radius >= request.largest_radius();
        if (found >= count &&
            (result.maximal || is_largest || (few > 0 && few < kNarrow * radius))) {
            cut(result, request->keep.size(), std::min(count, request->limit.value_or(count)));
            return result;
        }
        (found >= count ? many : few) = radius;
        if (few > 0 && many > 0)
            radius = std::sqrt(few * many);
        else
            radius *=
                found >= count ? 1.25 : std::min(0.98, std::sqrt(static_cast<double>(found) / aim));
        radius = std::min(radius, request.largest_radius());
        if (radius < request.smallest_radius())
            throw BadRequest("count", std::to_string(count),
                             "there is room for " + std::to_string(found) +
                                 " points at a radius of " + shortest(few) +
                                 ", and it cannot be smaller than the longest side / 2^20");
    }
}

SpaceResult sample(const SpaceRequest& request, Observer& observer) {
    Asked asked(observer, {0, request.count.value_or(request.limit.value_or(1)), 0});
    const CheckedRequest checked(request);
    backend_named(request.run_on);  // refused before memory and time are spent on a plan
    return request.count ? sample_count(checked, asked)
                         : sample_at(checked, *request.radius,
                                     request.limit.value_or(~std::uint64_t{0}), asked);
}

}  // namespace
}  // namespace space

SpaceResult sample_surface(const SpaceRequest& request, Observer& observer) {
    if (request.mesh == nullptr)
        throw BadRequest("mesh", "missing", "give one, or call sample_volume");
    return space::sample(request, observer);
}

SpaceResult sample_surface(const SpaceRequest& request) {
    Observer nobody;
    return sample_surface(request, nobody);
}

SpaceResult sample_volume(const SpaceRequest& request, Observer& observer) {
    if (request.mesh != nullptr)
        throw BadRequest("mesh", "for sample_volume", "is for sample_surface");
    return space::sample(request, observer);
}

SpaceResult sample_volume(const SpaceRequest& request) {
    Observer nobody;
    return sample_volume(request, nobody);
}

std::vector<Point3> normals_of(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    check_mesh(mesh);
    std::vector<Point3> normals;
    normals.reserve(triangles.size());
    for (const std::uint32_t number : triangles) {
        ask_after();
        if (number >= mesh.triangles.size())
            throw BadRequest("triangles", std::to_string(number),
                             "must be less than " + std::to_string(mesh.triangles.size()) +
                                 ", the number of triangles");
        const Point3 way = space::across(space::corners_of(mesh, number));
        const double length = space::length_of(way);
        normals.push_back(length > 0 ? Point3{way.x / length, way.y / length, way.z / length}
                                     : Point3{});
    }
    return normals;
}

}  // namespace lacuna
