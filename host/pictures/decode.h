// The readers of the picture formats, and what they have in common.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "files/parse.h"
#include "pictures/image.h"

namespace lacuna::pictures {

// A file as it was read.
struct Encoded {
    std::string_view bytes;
    const std::string& name;
    std::uint64_t max_pixels;
    std::uint64_t max_aspect;  // most that the longer side may be, in lengths of the shorter
    Reading reading{};

    [[noreturn]] void refuse(const std::string& why) const { files::refuse(name, why); }
};

// The size in pixels that a file states, before it is checked.
struct Size {
    std::uint64_t columns;
    std::uint64_t rows;

    std::uint64_t pixels() const { return columns * rows; }
};

// The characters that separate the words of a text header.
inline constexpr std::string_view kBlanks = " \t\n\v\f\r";

// A pixel's position in messages.
inline std::string place(std::size_t row, std::size_t column) {
    return fmt::format("row {}, column {} (from 0, top left)", row, column);
}

// Refuses a picture without pixels or over the limits.
void check_size(const Encoded& file, Size size);

// A picture with memory for its luminance. Check the size first, because it decides the memory.
Image make_image(const Encoded& file, Size size);

Image decode_png(const Encoded& file);
Image decode_jpeg(const Encoded& file);
Image decode_netpbm(const Encoded& file);
Image decode_pfm(const Encoded& file);
Image decode_hdr(const Encoded& file);
Image decode_npy(const Encoded& file);
Image decode_tiff(const Encoded& file);
Image decode_webp(const Encoded& file);
Image decode_heif(const Encoded& file);

// What to do with a HEIF where libheif is missing.
inline constexpr std::string_view kFromHeif =
    "a HEIF picture: convert it first, for example by heif-convert to PNG";

}  // namespace lacuna::pictures
