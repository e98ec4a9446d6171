// Reads files that hold one point set or several, and what they tell of the domain: this program's
// formats, and those of other programs that analyse point sets.
#pragma once

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/formats.h"
#include "files/parse.h"

namespace lacuna::files {

struct SetsOfFile {
    std::vector<std::vector<Point>> sets;
    std::optional<double> width;  // of the domain: of a .json file that tells it, with the height
    std::optional<double> height;
    std::optional<double> radius;  // likewise, as all below
    std::optional<Boundary> boundary;
    std::optional<std::string> mode;
    std::optional<bool> maximal;  // whether no room is left
    bool has_scale = false;       // its options have one: radii follow a picture
};

// Formats by extension; "-" is standard input, as txt:
//   txt   `x y` a line; blank lines and lines that begin with # are skipped. Where the first line
//         is one whole number N, as PSA writes it, N points follow
//   csv   `x,y` a line, likewise, and a first line of words is a header
//   npy   versions 1.0 to 3.0; N x 2, '<f8' or '<f4', C or Fortran order
//   ply   ascii or binary_little_endian; x and y of the element vertex, float or double
//   json  {"points": [[x, y], ...], ...} or the array alone
//   rps   PSA's binary files: x y x y ... as float32, little-endian
//   dat   UTK's text files: `x y` or `x<TAB>y` a line; a line that begins with # ends a set
// PSA is Schloemer & Deussen's point set analysis, UTK the Uni(corn|form) tool kit.
//
// Whatever could mean two things is refused: in a .txt a line of # alone between points (UTK's end
// of a set, but a comment here), and a count that is not that of the lines.
// Throws FileError in one line: the file, the place in it, what is there and what should be. NaN
// and infinity are refused, and so are pictures. Sets may be empty only where the file holds no
// point.
SetsOfFile read_sets(const std::string& path);

// The same for bytes that have been read. `name` stands for the file in messages.
SetsOfFile decode_sets(std::string_view bytes, const Format& format, const std::string& name);

// ------------------------------------------------------------------------ for the formats' readers

inline SetsOfFile one_set(std::vector<Point> points) {
    SetsOfFile file;
    file.sets.push_back(std::move(points));
    return file;
}

inline void check_finite(Point point, std::size_t index, const std::string& name) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        refuse(name, fmt::format("point {} is ({}, {}): both must be finite numbers", index,
                                 point.x, point.y));
}

}  // namespace lacuna::files
