// The resolution of a PNG: the chunk pHYs (PNG 1.2, 4.2.4.2).
#include "drawing/png.h"

#include <zlib.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "drawing/cairo_surface.h"
#include "drawing/picture.h"

namespace lacuna::drawing {
namespace {

void append_big_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<char>((value >> shift) & 0xffU));
}

// The chunk: length, type, data, and a checksum of the type and the data.
std::string chunk_of(double pixels_per_inch) {
    constexpr double kInchesPerMetre = 1000 / kMillimetresPerInch;
    constexpr std::string_view kType = "pHYs";
    constexpr char kPerMetre = 1;
    const auto pixels_per_metre =
        static_cast<std::uint32_t>(std::lround(pixels_per_inch * kInchesPerMetre));
    std::string checked(kType);
    append_big_endian(checked, pixels_per_metre);
    append_big_endian(checked, pixels_per_metre);
    checked.push_back(kPerMetre);

    std::string chunk;
    append_big_endian(chunk, static_cast<std::uint32_t>(checked.size() - kType.size()));
    chunk += checked;
    // The cast is safe: it is an array of bytes, which zlib declares unsigned.
    append_big_endian(
        chunk, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                                                static_cast<uInt>(checked.size()))));
    return chunk;
}

}  // namespace

std::string png_of(cairo_surface_t* image, double pixels_per_inch) {
    std::string bytes;
    check(cairo_surface_write_to_png_stream(image, append_to_string, &bytes));
    constexpr std::size_t kEndOfHeader = 8 + 25;  // the signature, then IHDR
    bytes.insert(kEndOfHeader, chunk_of(pixels_per_inch));
    return bytes;
}

}  // namespace lacuna::drawing
