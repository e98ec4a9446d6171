// What the readers of the several point formats share, and their names.
#pragma once

#include <fmt/format.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_sets.h"

namespace lacuna::files {

std::vector<Point> decode_lines(std::string_view bytes, bool is_csv, const std::string& name);
std::vector<Point> decode_npy(std::string_view bytes, const std::string& name);
std::vector<Point> decode_ply(std::string_view bytes, const std::string& name);
std::vector<Point> decode_json(std::string_view bytes, const std::string& name);
SetsOfFile decode_json_with_header(std::string_view bytes, const std::string& name);

// The text formats that hold a count or several sets: see read_sets.
std::vector<Point> decode_counted_lines(std::string_view bytes, const std::string& name);
std::vector<std::vector<Point>> decode_separated_lines(std::string_view bytes,
                                                       const std::string& name);

inline void check_finite(Point point, std::size_t index, const std::string& name) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        refuse(name, fmt::format("point {} is ({}, {}): both must be finite numbers", index,
                                 point.x, point.y));
}

}  // namespace lacuna::files
