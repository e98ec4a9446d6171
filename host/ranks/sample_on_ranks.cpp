// From a request to the ranks' strips.
#include "ranks/sample_on_ranks.h"

#include <algorithm>

#include "backends/backends.h"
#include "plan/plan.h"
#include "ranks/together.h"

namespace lacuna {
namespace {

// Replaces a count by a radius and a limit; see sample.cpp.
Request sized_for(const Request& request, int attempt) {
    Request sized = request;
    if (!request.count) return sized;
    sized.radius = radius_for_count(request, attempt);
    sized.count.reset();
    sized.limit = std::min(*request.count, request.limit.value_or(*request.count));
    return sized;
}

}  // namespace

void check_request_on_ranks(const Request& request) {
    check_request(request);
    if (request.mode != Mode::exact)
        throw BadRequest("mode", std::string(name_of(request.mode)), "must be exact on ranks");
    if (needs_radius_field(request))
        throw BadRequest("field", "given",
                         "fields, masks, borders and kept points are not for ranks");
}

std::uint32_t most_ranks(const Request& request) {
    return most_ranks(make_plan(sized_for(request, 0)));
}

ResultOnRanks sample_on_ranks(const Request& request, Ranks& ranks, Sink& sink,
                              Observer& observer) {
    for (int attempt = 0;; ++attempt) {
        const Request sized = sized_for(request, attempt);
        const Plan plan = make_plan(sized);
        const Strip strip = strip_of(plan, ranks.rank(), ranks.count());
        ReadyBackend ready;
        together(ranks, [&] { ready = make_backend(sized, strip.plan, observer); });
        sink.begin(plan);
        ResultOnRanks result{generate_on_ranks(plan, strip, *ready.backend, ranks, sink, observer),
                             plan.user_radius, plan.lines_per_radius, ready.name,
                             ready.backend->device()};
        if (!request.count || result.outcome.samples == *sized.limit) return result;
    }
}

}  // namespace lacuna
