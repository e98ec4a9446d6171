// Point files and pictures, named by their extension; a file appears whole or not at all.
#pragma once

#include <lacuna/files.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/formats.h"

namespace lacuna::files {

// Where a set comes from: .json, .svg and .pdf tell it.
struct Origin {
    std::string version;  // of the program
    std::string command;  // a command line that makes the same set
    Boundary boundary = Boundary::box;
    Mode mode = Mode::exact;
    std::uint64_t seed = 0;
    bool maximal = false;      // whether no room is left
    std::string options = {};  // a JSON object of all that decides the points
};

// The sizes of a set's dots and its place on paper, for those who draw it themselves: .csv, .npy,
// .ply and .json have them.
struct Dots {
    std::vector<double> radii;  // of each point, in the domain's units
    double millimetres_per_unit = 0;
    double left_mm = 0;    // of the domain, from the left edge of the page
    double bottom_mm = 0;  // from its lower edge

    // x, y and the radius of a dot, on the page, y upwards.
    double x_mm(Point point) const { return left_mm + point.x * millimetres_per_unit; }
    double y_mm(Point point) const { return bottom_mm + point.y * millimetres_per_unit; }
    double radius_mm(std::size_t index) const { return radii[index] * millimetres_per_unit; }
};

// A set of points with what a picture needs to know of it.
struct PointSet {
    std::span<const Point> points;
    double width = 1;  // of the domain
    double height = 1;
    // Least distance; dots are drawn with a third of it as their radius. 0: not known; dots are
    // then as large as those of a maximal set of as many points.
    double radius = 0;
    const Origin* origin = nullptr;  // null: not known
    const Dots* dots = nullptr;      // null: not wanted
};

using lacuna::ClosedPipe;
using lacuna::FileError;

// ASCII only: what the locale takes for a letter must not change which file is meant.
char lower_case(char c);

// The bytes of a file of that format.
//   txt   `x y` a line, 17 significant digits, so that reading gives back the same doubles
//   csv   the same with a header line `x,y`
//   npy   NumPy 1.0 header, N x 2 float64, little-endian, C order
//   ply   ASCII, vertex x y z as double, z = 0
//   json  {"width":..., "height":..., "radius":..., what the origin tells, "count":...,
//         "points":[[x,y],...]}
// With dots, csv, npy and ply have the columns x, y, (z,) radius, x_mm, y_mm and radius_mm, and
// json has "dots" before the points.
//   svg, pdf, png: black dots on white, y upwards; longer side 1024 pixels (png) or 512 points
// The same set gives the same bytes on every call. Throws FileError if a picture cannot be drawn.
inline std::string encode(const PointSet& set, const Format& format) {
    return format.encode(set);
}

// Writes `bytes` to `path` ("-": standard output), whole or not at all: into a new file beside it,
// then a rename. An older file of that name is untouched until then and hands on its permissions.
// Links are followed. What is not a regular file (a device, a pipe) and what descriptor_named()
// knows is written into instead.
// Throws FileError, and ClosedPipe when whoever read from a pipe has gone.
void write_whole(const std::string& path, std::string_view bytes);

// The descriptor that /dev/stdout, /dev/stderr, /dev/fd/N or /proc/self/fd/N names.
std::optional<int> descriptor_named(const std::string& path);

// SHA-256, in hex, of the points as little-endian float64 x0 y0 x1 y1 ...: what --report prints
// and what tests pin.
std::string sha256_of(std::span<const Point> points);
// The same of points that come in parts.
class Sha256OfPoints {
public:
    Sha256OfPoints();
    ~Sha256OfPoints();
    Sha256OfPoints(const Sha256OfPoints&) = delete;
    Sha256OfPoints& operator=(const Sha256OfPoints&) = delete;

    void add(std::span<const Point> points);
    std::string hex();  // once, at the end

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lacuna::files
