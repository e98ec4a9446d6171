// The format .rps of PSA, Schloemer & Deussen's point set analysis: x y x y ... as float32,
// little-endian. Files of this format are read, never written.
#include <fmt/core.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/read_sets.h"

namespace lacuna::files {

SetsOfFile decode_rps(std::string_view bytes, const std::string& name) {
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
    return one_set(std::move(points));
}

}  // namespace lacuna::files
