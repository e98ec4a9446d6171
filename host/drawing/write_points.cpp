// The public functions for point files.
#include <lacuna/files.h>

#include "files/formats.h"
#include "files/point_files.h"
#include "files/read_points.h"

namespace lacuna {
namespace {

std::string encode(std::span<const Point> points, const files::Format& format, const About& about) {
    return files::encode({points, about.domain, about.radius}, format);
}

}  // namespace

void write_points(const std::string& path, std::span<const Point> points, const About& about) {
    files::write_whole(path, encode(points, files::format_of(path), about));
}

std::string encode_points(std::span<const Point> points, std::string_view format,
                          const About& about) {
    const files::Format* const known = files::find_format(format);
    if (known == nullptr)
        throw BadRequest("format", std::string(format),
                         "must be one of " + files::written_extensions());
    return encode(points, *known, about);
}

std::vector<Point> read_points(const std::string& path) {
    return files::read_points(path).points;
}

}  // namespace lacuna
