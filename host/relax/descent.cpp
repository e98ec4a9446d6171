// Takes the steps of the Gaussian energy's descent, and reports each to the observer.
#include "relax/descent.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/number_text.h"
#include "relax/relax_backends.h"

namespace lacuna::relaxing {

void check_gaussian(const Field* importance, const RelaxOptions& options) {
    constexpr std::uint32_t kMostSteps = 10000;
    const std::string steps = std::to_string(options.gaussian);
    if (options.gaussian > kMostSteps)
        throw BadRequest("gaussian", steps, "must be at most " + std::to_string(kMostSteps));
    // This condition is also false for NaN.
    if (!(options.gaussian_distance >= 0 && options.gaussian_distance <= 1))
        throw BadRequest("gaussian-distance", shortest(options.gaussian_distance),
                         "must lie between 0 and 1 mean spacings");
    if (options.gaussian != 0 && importance != nullptr)
        throw BadRequest("gaussian", steps, "is for domains without a picture");
}

std::optional<GaussianField> checked_gaussian(std::size_t points, const Field* importance,
                                              const RelaxOptions& options) {
    check_gaussian(importance, options);
    if (options.gaussian == 0) return std::nullopt;
    return make_gaussian(points, options);
}

void descend(Relaxed& relaxed, const GaussianField& field, const RelaxOptions& options,
             Observer& observer) {
    std::vector<Point>& points = relaxed.points;
    std::uint64_t done = options.iterations;
    const std::uint64_t all = std::uint64_t{options.iterations} + options.gaussian;
    const auto may_go_on = [&] {
        return observer.keep_going(
            {points.size() * done, points.size() * all, done, Stage::relaxing, all});
    };
    const Poll poll = [&] {
        if (!may_go_on()) throw Cancelled();
    };
    observer.begin(Verb::first_use);
    const auto [name, backend] =
        make_gaussian_backend(options.run_on, field, spots_of(points, field, options, poll), poll);
    relaxed.backend = name;
    relaxed.device = backend->device();
    observer.end(Verb::first_use);
    backend->watch(may_go_on);
    for (std::uint32_t step = 0; step < options.gaussian; ++step) {
        observer.begin(Verb::descend);
        backend->descend(gaussian_pace(step));
        observer.end(Verb::descend);
        ++done;
        poll();
    }
    const std::vector<Spot> spots = backend->spots();
    const double unit_x = options.domain.width / field.domain.width;
    const double unit_y = options.domain.height / field.domain.height;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = options.domain.at({spots[i].x * unit_x, spots[i].y * unit_y});
}

}  // namespace lacuna::relaxing
