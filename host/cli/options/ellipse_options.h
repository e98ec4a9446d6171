// The options that give each sample an ellipse instead of a disk: --ellipses and --stretch.
#pragma once

#include <lacuna/lacuna.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/reports/output.h"

namespace lacuna::cli {

struct EllipseOptions {
    std::string path;  // of --ellipses; empty: not given
    std::string same;  // of --stretch

    bool are_given() const { return !path.empty() || !same.empty(); }
};

// The field of the ellipses, whose scale is 1. Throws BadRequest and files::FileError.
Field read_ellipses(const EllipseOptions& options);

nlohmann::ordered_json json_of(const EllipseOptions& options);

// The ellipse that A:B@DEGREES names. Throws BadRequest for --stretch.
Ellipse ellipse_from(const std::string& text);

// The ellipses of the points that were made of the request; empty if its field has no stretches.
std::vector<Ellipse> ellipses_of(const Request& request, const Result& result);

// Throws BadRequest if an output has no place for the columns.
void check_ellipse_columns(bool is_given, const std::vector<Output>& outputs);

}  // namespace lacuna::cli
