// Reads and writes point files, as the command does. Link lacuna::extras.
//
// What is promised
//   - A file appears whole or not at all: an older one of that name stays until the new one is
//     there. Devices and pipes are written into.
//   - .txt, .csv, .npy, .ply and .json hold every coordinate to the last bit: what is read is what
//     was written, in the same order.
//   - The same set gives the same bytes on every call. Pictures' letters and edges are cairo's and
//     may differ between its versions.
//   - What is read is checked: a file that is broken, or could mean two things, is refused in one
//     line that names the file, the place in it, what is there and what should be.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

// A file could not be read or written: names the path and the system's reason.
class FileError : public Error {
    using Error::Error;
};

// Nobody reads any more what is written into a pipe, as behind `| head -1`.
class ClosedPipe : public FileError {
    using FileError::FileError;
};

// What a file may tell of a set beside its points, or needs for a picture of them.
struct About {
    double width = 1;  // of the domain, as in Request
    double height = 1;
    double radius = 0;  // least distance; dots are drawn with a third of it as their radius. 0: not
                        // known; dots are then as large as those of a maximal set of as many points
};

// Writes points to `path`, in the format of its extension: .txt .csv .npy .ply .json, or as a
// picture .svg .pdf .png. "-" is standard output, as .txt.
// Throws BadRequest for another extension, FileError and ClosedPipe.
void write_points(const std::string& path, std::span<const Point> points, const About& about = {});

// The bytes of such a file, by the name of its format, such as "csv". Throws BadRequest.
std::string encode_points(std::span<const Point> points, std::string_view format,
                          const About& about = {});

// The points of a file that holds one set: .txt .csv .npy .ply .json, PSA's .rps or UTK's .dat. "-"
// is standard input, as .txt. Throws FileError.
std::vector<Point> read_points(const std::string& path);

}  // namespace lacuna
