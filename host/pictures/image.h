// Reads the luminance of each pixel of a picture.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::pictures {

// Limits of a picture: the longer side, and the number of pixels.
inline constexpr std::uint64_t kMaxSide = std::uint64_t{1} << 20U;
// The longest side of a domain, and so of a picture that is one, in shorter sides.
inline constexpr std::uint64_t kLargestAspect = 1000;
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 28U;

// The colour behind pixels that are not opaque.
enum class Backdrop { white, black };

// How much red, green and blue count, in 1/kAll; together kAll.
inline constexpr std::int32_t kAll = 10000;
struct Weights {
    std::int32_t red;
    std::int32_t green;
    std::int32_t blue;
};
inline constexpr Weights kLuminance{2126, 7152, 722};  // ITU-R BT.709-6, item 3.2

// How a pixel's channels become one number.
struct Reading {
    Backdrop backdrop = Backdrop::white;
    Weights weights = kLuminance;
    // Memory for the picture and what is made of it; a picture for which there is not enough is
    // refused. Luminance takes 8 bytes, and sampling from the field takes 12 more.
    std::uint32_t bytes_a_pixel = 20;
};

struct Image {
    std::uint32_t columns = 0;      // pixels, at least 1
    std::uint32_t rows = 0;         // pixels, at least 1
    std::vector<double> luminance;  // rows * columns values from 0 to white; row 0 is the top row
    double white = 1;               // the luminance that counts as white
    std::string name{};             // the picture's name in messages
    bool is_linear = false;         // with Tone::light the numbers are not decoded as sRGB
};

// The picture in the file, or on standard input for "-". The content decides the format, never the
// name:
//   PNG     every colour type, 1 to 16 bits, interlaced or not; Exif's orientation is applied
//   JPEG    grey, colour or CMYK (without a printer's profile: 1 - ink, times 1 - black), baseline
//           or progressive, 8 bits, Huffman coded; Exif's orientation is applied
//   TIFF    the first picture: what libtiff turns into colours of 8 bits, and 16 bits in rows, grey
//           or RGB; its orientation is applied
//   WebP    one picture; Exif's orientation is applied
//   HEIC, AVIF  one picture, upright, in 8 bits; if libheif is installed
//   PGM, PPM   P2, P3, P5 and P6, of any maxval; the first picture of the file
//   PFM     Pf and PF, both byte orders; the size of the scale factor is not used
//   HDR     Radiance, 32-bit_rle_rgbe and 32-bit_rle_xyze, rows from top to bottom (-Y n +X n)
//   npy     NumPy, rows x columns or rows x columns x 1, 3 or 4; bool, whole numbers and floats of
//           every size; row 0 on top
// Luminance of colour is 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). Alpha is composited over
// `backdrop`. Both use the numbers as they are stored, and no colour profile or transfer curve is
// undone here: see Tone::light.
// For Tone::light samples of 8 or 16 bits and maxval are encoded as sRGB; other numbers are light.
// Samples of 8 or 16 bits (in PGM and PPM: up to maxval) are divided by the largest possible
// sample, correctly rounded, and white is 1. Numbers of .npy, PFM and HDR stay as they are; white
// is the largest luminance in the picture, but at least 1.
//
// These are refused by a FileError of one line, with the file, what was found and what is allowed:
// other formats, broken and truncated files; pictures without a pixel or over the limits (before
// memory is allocated), or whose longer side exceeds `max_aspect` times the shorter; and NaN,
// infinity and negative numbers, with row and column.
Image read_image(const std::string& path, std::uint64_t max_aspect = kMaxSide,
                 const Reading& reading = {});

// Throws FileError if the first bytes of a file are not of one of these formats.
void check_format(std::string_view first, const std::string& name);

// read_image for the bytes of a file. `name` stands for the file in messages.
Image decode_image(std::string_view bytes, const std::string& name,
                   std::uint64_t max_pixels = kMaxPixels, std::uint64_t max_aspect = kMaxSide,
                   const Reading& reading = {});

// A picture's channels, each as an image. They are equal in a grey picture.
struct Colours {
    Image red;
    Image green;
    Image blue;
};

// decode_image for each channel. Radiance's XYZE pictures come as grey ones.
Colours decode_colours(std::string_view bytes, const std::string& name,
                       Backdrop backdrop = Backdrop::white, std::uint64_t max_aspect = kMaxSide);

}  // namespace lacuna::pictures
