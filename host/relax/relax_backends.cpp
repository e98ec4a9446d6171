// The list of backends that relax points, in order of preference.
#include "relax/relax_backends.h"

#include <cstdlib>
#include <string_view>

#include "relax/cpu/make_backend.h"
#include "relax/reference.h"

namespace lacuna::relaxing {
namespace {

struct Entry {
    std::string_view name;
    std::unique_ptr<RelaxBackend> (*make)(const Lattice&, std::span<const Site>, const Placement&);
};

constexpr Entry kBackends[] = {
    {"cpu", cpu::make_backend},
    {"reference", reference::make_backend},
};

std::string names() {
    std::string all = "auto";
    for (const Entry& entry : kBackends) all += ", " + std::string(entry.name);
    return all;
}

std::string wanted_backend(const RelaxOptions& options) {
    if (options.backend != "auto") return options.backend;
    const char* const forced = std::getenv("LACUNA_BACKEND");
    return forced != nullptr && *forced != '\0' ? forced : "auto";
}

}  // namespace

Chosen make_relax_backend(const RelaxOptions& options, const Lattice& lattice,
                          std::span<const Site> sites) {
    const std::string wanted = wanted_backend(options);
    for (const Entry& entry : kBackends)
        if (wanted == "auto" || wanted == entry.name)
            return {std::string(entry.name),
                    entry.make(lattice, sites, {options.device, options.threads})};
    throw BadRequest("backend", wanted, "must be one of " + names());
}

}  // namespace lacuna::relaxing
