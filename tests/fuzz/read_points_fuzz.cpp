// Given any bytes, the readers of points give points that are finite, or refuse in one line. The
// first byte chooses the format.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/point_files.h"
#include "files/read_points.h"

namespace {

using namespace lacuna;

void require(bool holds) {
    if (!holds) std::abort();
}

constexpr std::array kFormats{files::Format::txt, files::Format::csv, files::Format::npy,
                              files::Format::ply, files::Format::json};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const files::Format format = kFormats[data[0] % kFormats.size()];
    try {
        for (const Point& point :
             files::decode({reinterpret_cast<const char*>(data) + 1, size - 1}, format, "file"))
            require(std::isfinite(point.x) && std::isfinite(point.y));
    } catch (const files::FileError& error) {
        const std::string_view what = error.what();
        require(what.starts_with("file:") && what.find('\n') == std::string_view::npos);
    }
    return 0;
}
