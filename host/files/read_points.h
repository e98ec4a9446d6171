// Reads point files, and what they say about the set: this program's formats, as this program and
// others write them.
#pragma once

#include <fmt/core.h>
#include <lacuna/lacuna.h>
#include <lacuna/space.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/formats.h"
#include "files/parse.h"
#include "files/point_files.h"

namespace lacuna::files {

// The classes or inks of a file. There are none if no point has one.
struct LayersOfFile {
    std::vector<std::string> names;      // in a .ply, which has no names, their numbers
    std::vector<std::string> colours;    // only in .json, such as #009ee3
    std::vector<std::uint8_t> of_point;  // the place of each point's own among the names
    bool are_numbers = false;            // whether the names are the numbers 0, 1, 2 and so on
};

struct PointsOfFile {
    std::vector<Point> points{};
    std::vector<double> z{};         // of each point; empty: they have two coordinates
    std::optional<Domain> domain{};  // without its boundary; only in .json
    std::optional<double> depth{};   // of the volume; only in .json
    std::optional<double> radius{};  // only in .json, as the next two
    std::optional<Boundary> boundary{};
    Origin origin{};
    // In .csv, .ply and .json.
    LayersOfFile classes{};
    LayersOfFile inks{};
    // In .csv, .npy, .ply and .json: the ellipse of each point, or none.
    std::vector<Ellipse> ellipses{};
    // In .csv, .ply, .geojson and .json, the radius of each object of a kind that has sizes; empty
    // if points have no classes, or if the radii are those of dots on a page.
    std::vector<double> radii{};
    // The names of columns that were not read, such as radius. A command that writes these points
    // again would lose them.
    std::vector<std::string> other_columns{};

    // Whether a .json says that the points lie on a mesh or in a volume.
    bool is_said_to_be_in_space() const { return depth || origin.values.contains("on"); }
    // Points with three coordinates.
    std::vector<Point3> in_space() const;
};

// The format is chosen by the extension; "-" is standard input, as txt:
//   txt   `x y` on each line; blank lines and lines that begin with # are skipped. If the first
//         line is a single whole number N, as in PSA's files, N points must follow
//   csv   two columns with commas, semicolons or tabs between them, or more below a header that
//         calls two of them x and y, lon and lat, or easting and northing; comments and blank lines
//         as in txt. The columns class, ink, a,
//         b and angle are read, too
//   npy   versions 1.0 to 3.0; N x 2 or as this program writes it with dots or ellipses; whole or
//         floating-point numbers in either byte order, C or Fortran order
//   ply   ascii or binary; x and y of the element vertex, and the columns as in csv
//   json  {"points": [[x, y], ...], ...} or the array alone
// A third coordinate (a column z, or a third number in npy and json) must be the same for all
// points, and is dropped; points in space have one each, also as a third number in txt.
// PSA is Schloemer & Deussen's point set analysis.
// Ambiguous files are refused: a .txt file with a bare # on a line between points (in files of
// UTK, the Uni(corn|form) tool kit, the end of a set), or whose count differs from the number of
// points. NaN, infinity and pictures are refused, too. A set may be empty only if the whole file
// has no point. Throws FileError with one line: the file, the position in it, what was found and
// what was expected.
enum class Lie { in_plane, in_space, as_file_says };
PointsOfFile read_points(const std::string& path, Lie lie = Lie::in_plane);

// The same for the bytes of a file. `name` stands for the file in messages.
PointsOfFile decode(std::string_view bytes, const Format& format, const std::string& name,
                    Lie lie = Lie::in_plane);

// ------------------------------------------------------------------------ for the formats' readers

inline void check_finite(Point point, std::size_t index, const std::string& name) {
    ask_after(4);
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        refuse(name, fmt::format("point {} is ({}, {}): both must be finite numbers", index,
                                 point.x, point.y));
}

}  // namespace lacuna::files
