// Reads the sides of volumes, and refuses what sets in space do not have. The page has none of it.
#include "options/space.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "base/number_text.h"
#include "options/read.h"

namespace lacuna::options {
namespace {

// All other options are for sets in the plane.
constexpr std::array<std::string_view, 20> kOptionsInSpace{
    "FILE",   "on",         "domain",  "torus",   "radius",    "count",         "limit",
    "seed",   "round-size", "threads", "backend", "device",    "keep",          "output",
    "format", "quiet",      "report",  "json",    "tolerance", "distances-only"};

void take_sides_in_space(const std::string& text, InSpace& space) {
    const auto sides = std::count(text.begin(), text.end(), 'x') + 1;
    if (sides < 3) return read_domain("domain", text, space.request.domain);
    std::array<double, 3> read_as{};
    std::size_t begin = 0;
    try {
        for (double& side : read_as) {
            const std::size_t end = std::min(text.find('x', begin), text.size());
            read("domain", text.substr(begin, end - begin), side);
            begin = end + 1;
        }
    } catch (const BadRequest&) {
        begin = 0;
    }
    if (begin != text.size() + 1)
        throw BadRequest("domain", shown(text),
                         "must be WIDTHxHEIGHTxDEPTH of a volume, three numbers such as 1x1x0.5; "
                         "its lower corner is at 0, 0, 0");
    space.volume = {read_as[0], read_as[1], read_as[2]};
}

}  // namespace

Targets targets_of(InSpace& space) {
    return {{"on", &space.mesh}, {"domain", take_by<take_sides_in_space>(space)}};
}

void refuse_options_of_plane(const CommandLine& line, const InSpace& space) {
    const std::string with = !space.mesh.empty() ? "with --on"
                             : space.volume      ? "with a --domain of three sides"
                                                 : "with points in space";
    for (const auto& [name, values] : line.given) {
        const bool has_two_sides = name == "domain" && space.mesh.empty() && !space.volume;
        const bool is_of_plane =
            has_two_sides || std::find(kOptionsInSpace.begin(), kOptionsInSpace.end(), name) ==
                                 kOptionsInSpace.end();
        const bool is_of_volume = name == "domain" || name == "torus";
        if (!is_of_plane && (space.mesh.empty() || !is_of_volume)) continue;
        throw BadRequest(std::string(name), (values.empty() ? "" : values.front() + " ") + with,
                         is_of_plane ? "is for sets in the plane" : "the mesh is the domain");
    }
}

SpaceRequest request_of(const InSpace& space) {
    const Request& asked = space.request;
    SpaceRequest request{.volume = space.volume.value_or(Volume()),
                         .radius = asked.radius,
                         .count = asked.count,
                         .limit = asked.limit,
                         .seed = asked.seed,
                         .round_size = asked.paper2011.round_size,
                         .run_on = asked.run_on};
    request.volume.boundary = asked.domain.boundary;
    return request;
}

}  // namespace lacuna::options
