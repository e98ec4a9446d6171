// Reads point files: what encode() writes, and what other programs write in the same formats.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <string_view>
#include <vector>

#include "files/point_files.h"

namespace lacuna::files {

// The points of the file, in its order; "-" is standard input, as txt. Formats by extension:
//   txt   `x y` a line; blank lines and lines that begin with # are skipped
//   csv   `x,y` a line, likewise, and a first line of words is a header
//   npy   versions 1.0 to 3.0; N x 2, '<f8' or '<f4', C or Fortran order
//   ply   ascii or binary_little_endian; x and y of the element vertex, float or double
//   json  {"points": [[x, y], ...], ...} or the array alone
// Throws FileError in one line: the file, the place in it, what is there and what should be. NaN
// and infinity are refused, and so are pictures.
std::vector<Point> read_points(const std::string& path);

// The same for bytes that have been read. `name` stands for the file in messages.
std::vector<Point> decode(std::string_view bytes, Format format, const std::string& name);

}  // namespace lacuna::files
