// Reads and writes point files, like the command. Link lacuna::extras.
//
// What is promised
//   - A file appears whole or not at all: an older file of that name stays until the new one is
//     complete. Devices and pipes are written directly.
//   - .txt, .csv, .npy, .ply, .geojson and .json hold every coordinate to the last bit, and the
//     order of the points: reading gives back exactly what was written.
//   - The same set gives the same bytes on every call. In .png and .pdf they may differ between
//     versions of cairo, which draws them.
//   - A file that is broken or ambiguous is refused. The message is one line that names the file,
//     the line or offset in it, what was found and what was expected.
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

// A file could not be read or written: names the path and the system's reason.
class FileError : public Error {
    using Error::Error;
};

// The reader of a pipe has ended, as with `| head -1`.
class ClosedPipe : public FileError {
    using FileError::FileError;
};

// What a file says about a set besides its points. Pictures need it.
struct About {
    Domain domain{};
    double radius = 0;  // least distance; a dot's radius is a third of it. 0: not known; a maximal
                        // set with this number of points then gives the size of the dots
};

// Writes points to `path`, in the format of its extension: .txt .csv .npy .ply .geojson .json, or
// as a picture .svg .pdf .png. "-" is standard output, as .txt. Throws BadRequest for another
// extension, FileError and ClosedPipe.
void write_points(const std::string& path, std::span<const Point> points, const About& about = {});

// The bytes that write_points() writes; `format` is an extension without dot, such as "csv". Throws
// BadRequest.
std::string encode_points(std::span<const Point> points, std::string_view format,
                          const About& about = {});

// The points of a file: .txt .csv .npy .ply .geojson .json. "-" is standard input, as .txt. Throws
// FileError.
std::vector<Point> read_points(const std::string& path);

}  // namespace lacuna
