// Reads point files that hold one set.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <string_view>
#include <vector>

#include "files/formats.h"

namespace lacuna::files {

// The points of the file, in the file's order. Throws FileError where read_sets() does, and if the
// file holds several sets.
std::vector<Point> read_points(const std::string& path);

// The same for the bytes of a file. `name` stands for the file in messages.
std::vector<Point> decode(std::string_view bytes, const Format& format, const std::string& name);

}  // namespace lacuna::files
