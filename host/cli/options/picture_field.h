// A picture on the command line, as the field of a request.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <string>

#include "cli/app_fwd.h"
#include "pictures/importance.h"

namespace lacuna::cli {

struct Picture {
    std::string path;
    pictures::Importance importance;
    std::optional<Metric> metric;
};

// Adds IMAGE, --scale, --metric and the options of add_importance(). Returns IMAGE's option.
CLI::Option* add_picture(CLI::App& command, Picture& picture, Request& request);

// Adds --invert, --black, --white, --auto-levels, --sharpen, --gamma and --min-importance, and for
// commands that can make ellipses --along.
void add_importance(CLI::App& command, Picture& picture, bool has_ellipses = true);

// Reads the picture, and sets the request's domain to its shape with a longer side of 1. Throws
// BadRequest and files::FileError.
Field read_field(const Picture& picture, Request& request);

}  // namespace lacuna::cli
