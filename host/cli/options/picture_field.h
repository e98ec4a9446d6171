// A picture on the command line, as the field of a request.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <string>

#include "cli/app_fwd.h"
#include "pictures/importance.h"

namespace lacuna::cli {

struct Picture {
    std::string path;
    pictures::Importance importance;
    bool has_metric = false;  // --metric was given
};

// Adds IMAGE, --scale, --metric, --invert, --black, --white,
// --auto-levels, --gamma and --min-importance. Returns IMAGE's option.
CLI::Option* add_picture(CLI::App& command, Picture& picture, Request& request);

// --invert, --gamma and --min-importance alone.
void add_importance(CLI::App& command, Picture& picture);

// Of a domain, and so of a picture that gives it its shape; lacuna.h: Request::height.
inline constexpr std::uint64_t kLargestAspect = 1000;

// Reads the picture, and gives the request its shape: the longer side is 1. Throws BadRequest and
// files::FileError.
Field read_field(const Picture& picture, Request& request);

}  // namespace lacuna::cli
