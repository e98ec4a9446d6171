// Reads files that hold one point set or several, and what they tell of the domain: the formats of
// read_points, and those of other programs that analyse point sets.
#pragma once

#include <lacuna/lacuna.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::files {

struct SetsOfFile {
    std::vector<std::vector<Point>> sets;
    std::optional<double> width;  // of the domain: of a .json file that tells it, with the height
    std::optional<double> height;
    std::optional<double> radius;  // likewise
};

// What read_points reads, and
//   txt   where the first line is one whole number N, as PSA writes it: N lines of `x y` follow
//   rps   PSA's binary files: x y x y ... as float32, little-endian
//   dat   UTK's text files: `x y` or `x<TAB>y` a line; a line that begins with # ends a set
// PSA is Schloemer & Deussen's point set analysis, UTK the Uni(corn|form) tool kit.
//
// Whatever could mean two things is refused: in a .txt a line of # alone between points (UTK's end
// of a set, but a comment here), and a count that is not that of the lines.
// Throws FileError as read_points does. Sets may be empty only where the file holds no point.
SetsOfFile read_sets(const std::string& path);

}  // namespace lacuna::files
