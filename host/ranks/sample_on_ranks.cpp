// From a request to the ranks' strips.
#include "ranks/sample_on_ranks.h"

#include "backends/backends.h"
#include "plan/checked_request.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "ranks/together.h"
#include "sampling/count_search.h"

namespace lacuna {

void check_request_on_ranks(const Request& request) {
    check_request(request);
    if (request.mode != Mode::exact)
        throw BadRequest("mode", std::string(name_of(request.mode)), "must be exact on ranks");
    if (needs_radius_field(request))
        throw BadRequest("field", "given",
                         "fields, masks, borders, kept points and progressive orders are not for "
                         "ranks");
}

std::uint32_t most_ranks(const Request& request) {
    const CheckedRequest checked(request);
    return most_ranks(
        make_plan(request.count ? search_for_count(checked, nullptr)->next().request : checked));
}

ResultOnRanks sample_on_ranks(const Request& request, Ranks& ranks, Sink& sink,
                              Observer& observer) {
    const CheckedRequest checked(request);
    const auto search = request.count ? search_for_count(checked, nullptr) : nullptr;
    for (;;) {
        const CheckedRequest sized = search ? search->next().request : checked;
        const Plan plan = make_plan(sized);
        const Strip strip = strip_of(plan, ranks.rank(), ranks.count());
        ReadyBackend ready;
        together(ranks, [&] {
            ready = make_backend(sized->run_on, strip.plan, observer);
            if (ready.backend == nullptr)
                throw BadRequest("backend", ready.name,
                                 "makes whole sets only; here: auto, cpu, opencl or vulkan");
        });
        sink.begin(plan);
        ResultOnRanks result{generate_on_ranks(plan, strip, *ready.backend, ranks, sink, observer),
                             plan.user_radius, plan.lines_per_radius, ready.name,
                             ready.backend->device()};
        if (!search || search->is_enough(result.outcome.samples)) return result;
    }
}

}  // namespace lacuna
