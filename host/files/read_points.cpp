// Reads a file that must hold one set.
#include "files/read_points.h"

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/read_sets.h"
#include "files/read_whole.h"

namespace lacuna::files {
namespace {

std::vector<Point> only_set_of(SetsOfFile file, const std::string& name) {
    if (file.sets.size() != 1) refuse(name, fmt::format("{} sets: must be one", file.sets.size()));
    return std::move(file.sets.front());
}

}  // namespace

std::vector<Point> decode(std::string_view bytes, const Format& format, const std::string& name) {
    return only_set_of(decode_sets(bytes, format, name), name);
}

std::vector<Point> read_points(const std::string& path) {
    return only_set_of(read_sets(path), name_of(path));
}

}  // namespace lacuna::files
