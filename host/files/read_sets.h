// Reads files that hold one or several point sets, and what they say about the domain: this
// program's formats, and formats of other programs that analyse point sets.
#pragma once

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
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
    std::optional<double> width;  // width of the domain; only in .json, together with the height
    std::optional<double> height;
    std::optional<double> radius;  // only in .json, as all members below
    std::optional<Boundary> boundary;
    std::optional<std::string> mode;
    std::optional<bool> maximal;  // whether no further sample fits
    bool has_scale = false;       // whether the options have a scale: then radii follow a picture
    std::vector<Level> levels;    // of a progressive order
    // In .csv and .json: the names of classes, and the place of each point's class among them.
    std::vector<std::string> class_names;
    std::vector<std::uint8_t> class_of_point;
    // In .json: the distances of classes and how often each is drawn, as in Classes.
    std::vector<double> distances;
    std::vector<double> weights;
};

// The format is chosen by the extension; "-" is standard input, as txt:
//   txt   `x y` on each line; blank lines and lines that begin with # are skipped. If the first
//         line is a single whole number N, as in PSA's files, N points must follow
//   csv   `x,y` on each line; comments and blank lines as in txt; a first line of words is a
//   header.
//         A last column called class has the name of each point's class
//   npy   versions 1.0 to 3.0; N x 2, '<f8' or '<f4', C or Fortran order
//   ply   ascii or binary_little_endian; x and y of the element vertex, float or double
//   json  {"points": [[x, y], ...], ...} or the array alone
//   rps   PSA's binary files: x y x y ... as float32, little-endian
//   dat   UTK's text files: `x y` or `x<TAB>y` on each line; a line that begins with # ends a set
// PSA is Schloemer & Deussen's point set analysis, UTK the Uni(corn|form) tool kit.
// Ambiguous files are refused: a .txt file with a bare # on a line between points (the end of a set
// for UTK, a comment here), or whose count differs from the number of points. NaN, infinity and
// pictures are refused, too. A set may be empty only if the whole file has no point.
// Throws FileError with one line: the file, the position in it, what was found and what was
// expected.
SetsOfFile read_sets(const std::string& path);

// The same for the bytes of a file. `name` stands for the file in messages.
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
