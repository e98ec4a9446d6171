// A picture on the command line, as the field of a request.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <string>

#include "cli/options/bind.h"
#include "pictures/importance.h"

namespace lacuna::cli {

struct Picture {
    std::string path;
    pictures::Importance importance;
    std::optional<Metric> metric;
};

// The targets of --metric and of the options that say how a picture is read.
Targets targets_of(Picture& picture);

// Reads the picture, and sets the request's domain to its shape with a longer side of 1. Throws
// BadRequest and files::FileError.
Field read_field(const Picture& picture, Request& request);

}  // namespace lacuna::cli
