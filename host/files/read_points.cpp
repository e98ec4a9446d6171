// Chooses the reader of a point file.
#include "files/read_points.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/polling.h"
#include "files/formats.h"
#include "files/parse.h"
#include "files/read_whole.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

void refuse_picture(const Format& format, const std::string& name) {
    if (format.medium)
        refuse(name,
               "a picture, whose points are rounded to what can be seen: give the points as " +
                   read_extensions());
}

// Points of the plane may have a third coordinate in a file only if it is the same for all.
void flatten(PointsOfFile& file, const std::string& name) {
    for_each_polled(file.z.size(), ask, [&](std::size_t i) {
        if (file.z[i] != file.z.front())
            refuse(name, fmt::format("point {} has z {}, and point 0 has {}: points of the plane "
                                     "must have the same z, or none",
                                     i, file.z[i], file.z.front()));
    });
    file.z.clear();
}

void check_in_space(const PointsOfFile& file, const std::string& name) {
    if (file.z.size() != file.points.size())
        refuse(name, "has two coordinates for each point: points in space have x, y and z");
    for_each_polled(file.z.size(), ask, [&](std::size_t i) {
        if (!std::isfinite(file.z[i]))
            refuse(name, fmt::format("point {} has z {}: must be a finite number", i, file.z[i]));
    });
}

// `x y z` on each line.
PointsOfFile decode_txt_in_space(std::string_view bytes, const std::string& name) {
    bytes = without_byte_order_mark(bytes);
    PointsOfFile file;
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = take_line(bytes);
        if (is_skipped(line)) continue;
        std::array<double, 3> at{};
        std::string_view rest = line;
        bool are_numbers = true;
        for (double& one : at) {
            std::string_view word = take_word(rest);
            are_numbers = are_numbers && take_number(word, one) == std::errc{} && word.empty() &&
                          std::isfinite(one);
        }
        if (!are_numbers || !rest.empty())
            refuse(fmt::format("{}:{}", name, number),
                   fmt::format("{} must be three finite numbers, such as 0.25 0.75 0.5",
                               excerpt(line)));
        file.points.push_back({at[0], at[1]});
        file.z.push_back(at[2]);
    }
    return file;
}

}  // namespace

std::vector<Point3> PointsOfFile::in_space() const {
    std::vector<Point3> all;
    for_each_polled(points.size(), ask, [&](std::size_t i) {
        all.push_back({points[i].x, points[i].y, z[i]});
    });
    return all;
}

PointsOfFile decode(std::string_view bytes, const Format& format, const std::string& name,
                    Lie lie) {
    refuse_picture(format, name);
    if (lie == Lie::in_space && format.name() == "txt") return decode_txt_in_space(bytes, name);
    PointsOfFile file = format.decode(bytes, name);
    if (lie == Lie::as_file_says && file.is_said_to_be_in_space()) lie = Lie::in_space;
    if (lie == Lie::in_space) {
        check_in_space(file, name);
        return file;
    }
    if (file.is_said_to_be_in_space())
        refuse(name, "has points on a mesh or in a volume: these are for sample and verify alone");
    flatten(file, name);
    return file;
}

PointsOfFile read_points(const std::string& path, Lie lie) {
    const Format* const format = path == "-" ? find_format("txt") : find_format_of(path);
    if (format == nullptr)
        refuse(path, "not a point file: the extension must be one of " + read_extensions());
    refuse_picture(*format, path);  // before the file is read
    return decode(read_whole(path), *format, name_of(path), lie);
}

}  // namespace lacuna::files
