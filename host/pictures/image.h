// Reads pictures: the luminance of each pixel, from the formats that importance comes in.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::pictures {

// No side of a picture may be longer than this, in pixels, and no picture may have more pixels.
inline constexpr std::uint64_t kMaxSide = std::uint64_t{1} << 20U;
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 28U;

// What shows through pixels that are not opaque.
enum class Backdrop { white, black };

struct Image {
    std::uint32_t columns = 0;      // pixels, at least 1
    std::uint32_t rows = 0;         // pixels, at least 1
    std::vector<double> luminance;  // rows * columns values from 0 to white; row 0 is the top row
    double white = 1;               // the luminance that counts as white
    std::string name;               // what messages call the picture
};

// The picture in the file, or on standard input for "-". The format is told by the content, never
// by the name:
//   PNG     every colour type, 1 to 16 bits, interlaced or not
//   JPEG    grey, colour or CMYK (without a printer's profile: 1 - ink, times 1 - black), baseline
//   or progressive, 8 bits, Huffman coded; Exif's orientation is
//           applied, but not that of other formats
//   PGM, PPM   P2, P3, P5 and P6, of any maxval; of several pictures in one file the first
//   PFM     Pf and PF, both byte orders; the size of the scale factor is not used
//   HDR     Radiance, 32-bit_rle_rgbe and 32-bit_rle_xyze, rows from top to bottom (-Y n +X n)
//   npy     NumPy, rows x columns or rows x columns x 1, 3 or 4; bool, whole
//           numbers and floats of every size; row 0 on top
// Luminance of colour is 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709) and alpha is composited
// over white, or what else is asked for, both on the numbers as they are stored: no colour profile
// or transfer curve is undone, since importance is a wish and not a measure of light, and what is
// seen as half grey should count half. Samples of 8 or 16 bits (of PGM and PPM: up to maxval) count
// as sample / largest possible sample, correctly rounded, and white is 1. Other numbers, of .npy,
// PFM and HDR, count as they are; white is the largest luminance in the picture if that is over 1,
// and otherwise 1.
//
// Refused, by a FileError of one line that names the file, what was found and what is allowed:
// other formats, broken and truncated files, pictures without a pixel or over the limits above
// (before memory is taken for them), and NaN, infinity and negative numbers, with row and column.
// The longer side may be at most `max_aspect` times the shorter.
Image read_image(const std::string& path, std::uint64_t max_aspect = kMaxSide);

// The same for bytes that have been read. `name` stands for the file in messages.
Image decode_image(std::string_view bytes, const std::string& name,
                   std::uint64_t max_pixels = kMaxPixels, std::uint64_t max_aspect = kMaxSide,
                   Backdrop backdrop = Backdrop::white);

}  // namespace lacuna::pictures
