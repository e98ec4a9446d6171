// Pieces of JSON that are written as text, because a tree of values takes gigabytes.
#pragma once

#include <string>

#include "files/point_files.h"

namespace lacuna::files {

// Appends the shortest digits that read back as `value`. Whole numbers get ".0", so that readers
// which distinguish 1 from 1.0 see a float, and -0.0 keeps its sign.
void append_json_number(std::string& bytes, double value);

// A text in quotes. It need not be valid UTF-8.
std::string quoted_json(const std::string& text);

// Appends the members that say how a set was made, each with a comma before it.
void append_origin(std::string& bytes, const Origin& origin);

}  // namespace lacuna::files
