// Sets in space by the options of the command, for the command and lacuna.h.
#pragma once

#include <lacuna/space.h>

#include <optional>
#include <string>

#include "options/targets.h"

namespace lacuna::options {

// What is asked for if it is in space.
struct InSpace {
    Request& request;                // what sets of the plane have, too
    std::string mesh{};              // path of --on
    std::optional<Volume> volume{};  // of a --domain of three sides, without its boundary

    bool is_asked_for() const { return !mesh.empty() || volume; }
};

// The targets of --on and of --domain, which has two sides or three.
Targets targets_of(InSpace& space);

// Throws BadRequest for an option that sets in space do not have.
void refuse_options_of_plane(const CommandLine& line, const InSpace& space);

// The radius, the count and other numbers of the request, and the volume.
SpaceRequest request_of(const InSpace& space);

}  // namespace lacuna::options
