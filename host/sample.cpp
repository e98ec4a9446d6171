// lacuna::sample: from the request to the points, by way of the plan and a backend's rounds.
#include <algorithm>
#include <string_view>
#include <utility>

#include "backends.h"
#include "lacuna/lacuna.h"
#include "plan.h"

namespace lacuna {
namespace {

Result run(const Request& request, Observer& observer) {
    const Plan plan = make_plan(request);
    const Run run = run_on_backend(request, plan, observer);
    Result result;
    result.points.reserve(run.outcome.samples.size());
    for (const Sample& sample : run.outcome.samples) result.points.push_back(plan.to_user(sample));
    result.radius = plan.user_radius;
    result.lines_per_radius = plan.lines_per_radius;
    result.maximal = run.outcome.samples.size() < plan.limit;
    result.rounds = run.outcome.rounds;
    result.draws = run.outcome.draws;
    result.backend = run.backend;
    result.device = run.device;
    return result;
}

}  // namespace

std::string_view name_of(Mode mode) {
    return mode == Mode::exact ? "exact" : "lines";
}

std::string_view name_of(Verb verb) {
    switch (verb) {
        case Verb::invert:
            return "invert";
        case Verb::locate:
            return "locate";
        case Verb::admit:
            return "admit";
        case Verb::subtract:
            return "subtract";
        case Verb::refine:
            return "refine";
        case Verb::transfer:
            return "transfer";
        case Verb::first_use:
            return "first_use";
    }
    return "";
}

Result sample(const Request& request, Observer& observer) {
    check_request(request);
    if (request.radius) return run(request, observer);

    // A count: at a radius with room to spare it is met at the first attempt but for a few in a
    // hundred thousand seeds, and a short set is drawn again with more to spare.
    for (int attempt = 0;; ++attempt) {
        Request sized = request;
        sized.radius = radius_for_count(request, attempt);
        sized.count.reset();
        const std::uint64_t count = *request.count;
        sized.limit = std::min(count, request.limit.value_or(count));
        Result result = run(sized, observer);
        if (result.points.size() == *sized.limit) return result;
    }
}

Result sample(const Request& request) {
    Observer nobody;
    return sample(request, nobody);
}

}  // namespace lacuna
