// Chooses the reader of a point file.
#include "files/read_points.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "files/formats.h"
#include "files/parse.h"
#include "files/read_whole.h"

namespace lacuna::files {
namespace {

void refuse_picture(const Format& format, const std::string& name) {
    if (format.medium)
        refuse(name,
               "a picture, whose points are rounded to what can be seen: give the points as " +
                   read_extensions());
}

}  // namespace

PointsOfFile decode(std::string_view bytes, const Format& format, const std::string& name) {
    refuse_picture(format, name);
    return format.decode(bytes, name);
}

PointsOfFile read_points(const std::string& path) {
    const Format* const format = path == "-" ? find_format("txt") : find_format_of(path);
    if (format == nullptr)
        refuse(path, "not a point file: the extension must be one of " + read_extensions());
    refuse_picture(*format, path);  // before the file is read
    return decode(read_whole(path), *format, name_of(path));
}

}  // namespace lacuna::files
