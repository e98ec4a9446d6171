// The options that give each sample an ellipse instead of a disk: --ellipses and --stretch.
#pragma once

#include <lacuna/lacuna.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/reports/output.h"

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

// The ellipse that A:B@DEGREES names. Throws BadRequest for --stretch.
Ellipse ellipse_from(const std::string& text);

// Adds --ellipse-columns, which sets `is_given`.
void add_ellipse_columns(CLI::App& command, bool& is_given);
// Refuses the option for sets of disks.
void check_ellipse_columns(bool is_given, bool has_ellipses);

// The ellipses of the points that were made of the request; empty if its field has no stretches.
std::vector<Ellipse> ellipses_of(const Request& request, const Result& result);

// Throws BadRequest if an output has no place for the columns.
void check_ellipse_columns(bool is_given, const std::vector<Output>& outputs);

}  // namespace lacuna::cli
