// lacuna::sample_surface and sample_volume: from a request to points in space.
#include <lacuna/space.h>

#include <algorithm>
#include <cmath>
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
#include "space/cpu_backend.h"
#include "space/plan.h"
#include "space/reference.h"
#include "space/samples.h"
#include "space/vectors.h"

namespace lacuna {
namespace space {
namespace {

// Kept points that are closer than the radius, also by rounding.
void check_kept_distances(const CheckedRequest& request, const Plan& plan) {
    const FirstBins& all = *plan.space().first_bins;
    const Samples samples(all, plan.radius_squared);
    std::vector<Position> near;
    const double radius = plan.user_radius;
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
                close += std::sqrt(x * x + y * y + z * z) < radius * (1 - 1e-9) ? 1 : 0;
            }
            if (close > 0)
                throw BadRequest("keep", "points that are closer than " + shortest(radius),
                                 "must keep the radius from each other");
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

SpaceResult sample_at(const CheckedRequest& request, double radius, Observer& observer) {
    const Plan plan = request.plan(radius);
    check_kept_distances(request, plan);
    SpaceResult result{.radius = radius};
    const std::string wanted = wanted_backend(request->run_on.backend);
    OutcomeOf<SpaceSample> outcome;
    if (!request->run_on.device.empty())
        throw BadRequest("device", request->run_on.device, "is for sets in the plane");
    if (wanted == "reference") {
        outcome = reference_samples(plan, observer);
        result.device = "1 thread";
    } else if (wanted == "cpu" || wanted == "auto") {
        const auto backend = make_cpu_backend(plan, request->run_on.threads);
        std::vector<SpaceSample> all;
        all.reserve(plan.expected_samples);
        outcome = generate<SpaceSample>(plan, *backend, observer,
                                        [&](std::span<const SpaceSample> samples) {
                                            all.insert(all.end(), samples.begin(), samples.end());
                                        });
        outcome.samples = std::move(all);
        result.device = backend->device();
    } else if (wanted == "opencl" || wanted == "vulkan") {
        throw Unavailable("backend " + wanted + ": makes sets in the plane alone");
    } else {
        throw no_such_backend(wanted);
    }
    result.backend = wanted == "auto" ? "cpu" : wanted;
    result.maximal = !outcome.is_cut;
    result.rounds = outcome.rounds;
    result.draws = outcome.draws;
    const auto members = static_cast<std::ptrdiff_t>(
        std::min<std::uint64_t>(request->keep.size(), request->limit.value_or(~std::uint64_t{0})));
    result.points.reserve(request->keep.size() + outcome.samples.size());
    result.points.assign(request->keep.begin(), request->keep.begin() + members);
    append(request, plan, outcome.samples, result);
    return result;
}

// A count: the first points of a maximal set that has somewhat more.
SpaceResult sample_count(const CheckedRequest& request, Observer& observer) {
    constexpr double kDeviations = 4 * kCountDeviation;
    const auto count = static_cast<double>(*request->count);
    if (*request->count < request->keep.size())
        throw BadRequest("count", std::to_string(*request->count),
                         "must be at least " + std::to_string(request->keep.size()) +
                             ", the number of kept points, which count");
    const double aim = count + kDeviations * std::sqrt(count) + 1;
    double expecting = aim;
    for (;;) {
        const double radius = request.radius_expecting(expecting);
        SpaceResult result = sample_at(request, radius, observer);
        const auto found = static_cast<double>(result.points.size());
        if (found >=
            std::min<double>(count, static_cast<double>(request->limit.value_or(*request->count))))
            return result;
        // Where a surface is curved or thin, other numbers find room than are expected.
        expecting *= std::max(1.02, aim / std::max(found, 1.0));
    }
}

SpaceResult sample(const SpaceRequest& request, Observer& observer) {
    Asked asked(observer, {0, request.count.value_or(request.limit.value_or(1)), 0});
    const CheckedRequest checked(request);
    return request.count ? sample_count(checked, asked)
                         : sample_at(checked, *request.radius, asked);
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
