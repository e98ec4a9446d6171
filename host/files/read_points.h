// Reads point files that hold one set.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <string_view>
#include <vector>

#include "files/formats.h"

namespace lacuna::files {

// The points of the file, in its order: what read_sets() reads, where it is one set. Throws
// FileError as read_sets() does, and for several sets.
std::vector<Point> read_points(const std::string& path);

// The same for bytes that have been read. `name` stands for the file in messages.
std::vector<Point> decode(std::string_view bytes, const Format& format, const std::string& name);

}  // namespace lacuna::files
