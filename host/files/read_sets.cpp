// Which reader a file of sets is for, and the binary one.
#include "files/read_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_points_formats.h"
#include "files/read_whole.h"

namespace lacuna::files {
namespace {

std::vector<Point> decode_rps(std::string_view bytes, const std::string& name) {
    constexpr std::size_t kPointSize = 2 * sizeof(float);
    if (bytes.size() % kPointSize != 0)
        refuse(name,
               fmt::format("{} bytes: must be a multiple of 8, x and y as float32", bytes.size()));
    std::vector<Point> points;
    points.reserve(bytes.size() / kPointSize);
    for (; !bytes.empty(); bytes.remove_prefix(kPointSize)) {
        points.push_back({load_little_endian<float>(bytes),
                          load_little_endian<float>(bytes.substr(sizeof(float)))});
        check_finite(points.back(), points.size() - 1, name);
    }
    return points;
}

// With its dot, in lower case.
std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), lower_case);
    return extension;
}

bool is_known(const std::string& path) {
    try {
        format_of(path);
        return true;
    } catch (const BadRequest&) {
        return false;
    }
}

SetsOfFile one_set(std::vector<Point> points) {
    SetsOfFile file;
    file.sets.push_back(std::move(points));
    return file;
}

}  // namespace

SetsOfFile read_sets(const std::string& path) {
    const std::string name = name_of(path);
    const std::string extension = extension_of(path);
    if (path == "-" || extension == ".txt")
        return one_set(decode_counted_lines(read_whole(path), name));
    if (extension == ".rps") return one_set(decode_rps(read_whole(path), name));
    if (extension == ".json") return decode_json_with_header(read_whole(path), name);
    if (extension == ".dat") {
        SetsOfFile file;
        file.sets = decode_separated_lines(read_whole(path), name);
        return file;
    }
    if (!is_known(path))
        refuse(
            path,
            "not a point file: the extension must be one of .txt .csv .npy .ply .json .dat .rps");
    return one_set(read_points(path));
}

}  // namespace lacuna::files
