// Given any bytes, the readers of points give points that are finite, or refuse in one line. The
// first byte chooses the format.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

#include "files/point_files.h"
#include "files/read_points.h"

namespace {

using namespace lacuna;

void require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::span<const files::Format> formats = files::formats();
    const files::Format& format = formats[data[0] % formats.size()];
    if (format.decode == nullptr) return 0;
    try {
        const files::PointsOfFile file =
            format.decode({reinterpret_cast<const char*>(data) + 1, size - 1}, "file");
        for (const Point& point : file.points)
            require(std::isfinite(point.x) && std::isfinite(point.y));
    } catch (const files::FileError& error) {
        const std::string_view what = error.what();
        require(what.starts_with("file:") && what.find('\n') == std::string_view::npos);
    }
    return 0;
}
