// The list of backends, and the choice among them.
#include "backends.h"

#include <algorithm>
#include <cstdlib>

#include "reference/reference.h"

namespace lacuna {
namespace {

struct Entry {
    std::string_view name;
    // Throws Unavailable when there is no such device.
    Run (*run)(const Request&, const Plan&, Observer&);
};

Run run_reference(const Request&, const Plan& plan, Observer& observer) {
    return {reference::sample(plan, observer), "", "1 thread"};
}

// In order of preference.
constexpr Entry kBackends[] = {
    {"reference", run_reference},
};

std::string names() {
    std::string all = "auto";
    for (const Entry& entry : kBackends) all += ", " + std::string(entry.name);
    return all;
}

// The request's choice, or else the environment's.
std::string wanted_backend(const Request& request) {
    if (request.backend != "auto") return request.backend;
    const char* forced = std::getenv("LACUNA_BACKEND");
    return forced != nullptr && *forced != '\0' ? forced : "auto";
}

}  // namespace

Run run_on_backend(const Request& request, const Plan& plan, Observer& observer) {
    const std::string wanted = wanted_backend(request);
    for (const Entry& entry : kBackends) {
        if (wanted != "auto" && wanted != entry.name) continue;
        Run run = entry.run(request, plan, observer);
        run.backend = entry.name;
        return run;
    }
    throw BadRequest("backend", wanted, "must be one of " + names());
}

}  // namespace lacuna
