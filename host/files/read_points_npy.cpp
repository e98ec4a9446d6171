// Points of NumPy's format .npy.
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/npy.h"
#include "files/read_points_formats.h"

namespace lacuna::files {
namespace {

template <class Number>
std::vector<Point> load_points(std::string_view data, const NpyHeader& header,
                               const std::string& name) {
    const std::uint64_t count = header.shape[0];
    const std::size_t whole = data.size() / (2 * sizeof(Number));
    if (count != whole || data.size() % (2 * sizeof(Number)) != 0)
        refuse(name, fmt::format("{} bytes of data: {} points of {} bytes each are announced",
                                 data.size(), count, 2 * sizeof(Number)));
    // In units of numbers: from one point to the next, and from x to y.
    const std::size_t step = header.fortran_order ? 1 : 2;
    const std::size_t to_y = header.fortran_order ? whole : 1;
    std::vector<Point> points(whole);
    for (std::size_t i = 0; i < whole; ++i) {
        const auto at = [&](std::size_t k) {
            return double{load_little_endian<Number>(data.substr(k * sizeof(Number)))};
        };
        points[i] = {at(i * step), at(i * step + to_y)};
        check_finite(points[i], i, name);
    }
    return points;
}

}  // namespace

std::vector<Point> decode_npy(std::string_view bytes, const std::string& name) {
    const NpyHeader header = take_npy_header(bytes, name);
    if (header.shape.size() != 2 || header.shape[1] != 2)
        refuse(name, fmt::format("an array of shape {}: must be N x 2", shape_text(header.shape)));
    if (header.descr == "<f8") return load_points<double>(bytes, header, name);
    if (header.descr == "<f4") return load_points<float>(bytes, header, name);
    refuse(name, fmt::format("numbers of type {}: must be '<f8' or '<f4', little-endian floats",
                             excerpt(header.descr)));
}

}  // namespace lacuna::files
