// Points in a file, the picture that they follow, and their domain: what `lacuna relax` and
// `lacuna order` are given.
#pragma once

#include <lacuna/lacuna.h>

#include <optional>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/given_files.h"
#include "cli/options/picture_field.h"

namespace lacuna::cli {

struct GivenSet {
    std::string points;  // path
    Picture picture;     // its path is empty if there is none
    bool has_domain = false;
};

// Adds POINTS, IMAGE, --domain and --torus; `set` and `request` must outlive the command.
void add_given_set(CLI::App& command, GivenSet& set, Request& request);

std::vector<GivenFile> files_of(const GivenSet& set);

// Reads the points, which must be one set, and the picture. Sets the request's domain: as given, or
// the picture's shape, or what the file of the points tells.
struct SetAndField {
    std::vector<Point> points;
    std::optional<Field> field;
};
SetAndField read_given_set(const GivenSet& set, Request& request);

}  // namespace lacuna::cli
