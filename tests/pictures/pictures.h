// Picture files for tests of the readers, made without the readers' code: by libpng's and libjpeg's
// writers, and from bytes put together here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::pictures {

using Samples = std::vector<std::uint16_t>;

// The options for libpng's writer; types and filters are its PNG_ constants.
struct Png {
    std::uint32_t columns = 1;
    std::uint32_t rows = 1;
    int depth = 8;
    int colour_type = 0;
    bool interlaced = false;
    std::vector<std::array<std::uint8_t, 3>> palette{};
    std::vector<std::uint8_t> palette_alpha{};
    Samples transparent{};  // the grey, or the red, green and blue, that is transparent
    bool with_profile_and_text = false;
};

// Samples of 0 to `max`, neither constant nor symmetric.
Samples pattern(std::size_t count, unsigned max);

// `samples`: row by row, channel by channel, each below 2^depth.
std::string png_bytes(const Png& png, const Samples& samples);

// PNG's four numbers around data, CRC included.
std::string png_chunk(const std::string& type, const std::string& data);

struct Jpeg {
    std::uint32_t columns = 1;
    std::uint32_t rows = 1;
    int channels = 1;  // 4: CMYK
    bool progressive = false;
    bool arithmetic = false;
    std::string app1{};  // the content of a marker APP1
};

std::string jpeg_bytes(const Jpeg& jpeg, const Samples& samples);

// An Exif marker whose first directory gives `orientation`.
std::string exif(int orientation, bool big_endian);

// The numbers in a byte order.
std::string packed(const std::vector<float>& values, bool big_endian);
std::string packed(const std::vector<double>& values, bool big_endian);
std::string packed(const Samples& values, bool big_endian);
std::string bytes_of(const Samples& values);

std::string npy_bytes(const std::string& descr, const std::string& shape, const std::string& data,
                      bool fortran_order = false);

// A small valid file of every format and kind, by name.
std::vector<std::pair<std::string, std::string>> one_of_each();

}  // namespace lacuna::pictures
