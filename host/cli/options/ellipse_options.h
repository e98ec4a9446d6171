// The options that give each sample an ellipse instead of a disk: --ellipses and --stretch.
#pragma once

#include <lacuna/lacuna.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli/app_fwd.h"

namespace lacuna::cli {

struct EllipseOptions {
    std::string path;  // of --ellipses; empty: not given
    std::string same;  // of --stretch

    bool are_given() const { return !path.empty() || !same.empty(); }
};

void add_ellipses(CLI::App& command, EllipseOptions& options);

// Checks that not both are given. Throws BadRequest.
void check(const EllipseOptions& options);

// The field of the ellipses, whose scale is 1. Throws BadRequest and files::FileError.
Field read_ellipses(const EllipseOptions& options);

nlohmann::ordered_json json_of(const EllipseOptions& options);

}  // namespace lacuna::cli
