// What a .json says of the options that its set was made with, for `lacuna verify`: values are
// used where no option is given, and files are asked for.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "cli/app_fwd.h"
#include "cli/options/domain_options.h"
#include "files/read_sets.h"

namespace lacuna::cli {

// Throws BadUsage if the set in `file` was made with a picture, polygons or obstacles that
// the command was not given, or with another tone of the field. For distances alone only ellipses
// are needed. `name` stands for the file.
void ask_for_files(const CLI::App& command, const DomainOptions& options, bool distances_only,
                   const files::SetsOfFile& file, const std::string& name);

// Fills in the scale, the border and how far edges may be off, where the command was not given
// them. If the set has the same ellipse everywhere, returns its field, to which `request` points.
std::shared_ptr<const Field> use_values(const CLI::App& command, const files::SetsOfFile& file,
                                        Request& request, std::optional<double>& edge);

// How many points of the set were kept: it begins with them.
std::size_t kept_in(const files::SetsOfFile& file);

}  // namespace lacuna::cli
