// Point files and pictures, named by their extension; a file appears whole or not at all.
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/formats.h"

namespace lacuna::files {

// A set of points with what a picture needs to know of it.
struct PointSet {
    std::span<const Point> points;
    double width = 1;  // of the domain
    double height = 1;
    // Least distance; dots are drawn with a third of it as their radius. 0: not known; dots are
    // then as large as those of a maximal set of as many points.
    double radius = 0;
};

// A file could not be read or written: names the path and the system's reason.
class FileError : public Error {
    using Error::Error;
};

// Nobody reads any more what is written into a pipe, as behind `| head -1`.
class ClosedPipe : public FileError {
    using FileError::FileError;
};

// ASCII only: what the locale takes for a letter must not change which file is meant.
char lower_case(char c);

// The bytes of a file of that format.
//   txt   `x y` a line, 17 significant digits, so that reading gives back the same doubles
//   csv   the same with a header line `x,y`
//   npy   NumPy 1.0 header, N x 2 float64, little-endian, C order
//   ply   ASCII, vertex x y z as double, z = 0
//   json  {"width":..., "height":..., "radius":..., "count":..., "points":[[x,y],...]}
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

}  // namespace lacuna::files
