// The bytes of a point file, and which reader they are for.
#include "files/read_points.h"

#include <string>
#include <string_view>
#include <vector>

#include "files/read_points_formats.h"
#include "files/read_whole.h"

namespace lacuna::files {
namespace {

Format format_to_read(const std::string& path) {
    try {
        return format_of(path);
    } catch (const BadRequest&) {
        refuse(path, "not a point file: the extension must be one of .txt .csv .npy .ply .json");
    }
}

void refuse_picture(Format format, const std::string& name) {
    if (format == Format::svg || format == Format::pdf || format == Format::png)
        refuse(name,
               "a picture, whose points are rounded to what can be seen: give the points as "
               ".txt .csv .npy .ply or .json");
}

}  // namespace

std::vector<Point> decode(std::string_view bytes, Format format, const std::string& name) {
    refuse_picture(format, name);
    switch (format) {
        case Format::csv:
            return decode_lines(bytes, true, name);
        case Format::npy:
            return decode_npy(bytes, name);
        case Format::ply:
            return decode_ply(bytes, name);
        case Format::json:
            return decode_json(bytes, name);
        default:
            return decode_lines(bytes, false, name);
    }
}

std::vector<Point> read_points(const std::string& path) {
    const Format format = format_to_read(path);
    refuse_picture(format, path);
    return decode(read_whole(path), format, name_of(path));
}

}  // namespace lacuna::files
