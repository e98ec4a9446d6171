// Writers of test pictures.
#include "pictures/pictures.h"

#include <cstdio>  // for jpeglib.h

#include <jpeglib.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <string_view>

namespace lacuna::pictures {
namespace {

void append(png_structp png, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(data, data + size);
}

int channels_of(int colour_type) {
    const bool has_alpha = (colour_type & PNG_COLOR_MASK_ALPHA) != 0;
    const bool has_colour = colour_type == PNG_COLOR_TYPE_RGB || colour_type == PNG_COLOR_TYPE_RGBA;
    return (has_colour ? 3 : 1) + (has_alpha ? 1 : 0);
}

void set_palette(png_structp png, png_infop info, const Png& picture) {
    std::vector<png_color> colours;
    for (const auto& [red, green, blue] : picture.palette) colours.push_back({red, green, blue});
    png_set_PLTE(png, info, colours.data(), static_cast<int>(colours.size()));
    if (!picture.palette_alpha.empty())
        png_set_tRNS(png, info, picture.palette_alpha.data(),
                     static_cast<int>(picture.palette_alpha.size()), nullptr);
}

void set_transparent(png_structp png, png_infop info, const Samples& colour) {
    png_color_16 transparent{};
    transparent.gray = colour[0];
    if (colour.size() == 3) {
        transparent.red = colour[0];
        transparent.green = colour[1];
        transparent.blue = colour[2];
    }
    png_set_tRNS(png, info, nullptr, 0, &transparent);
}

void set_profile_and_text(png_structp png, png_infop info) {
    png_set_gAMA(png, info, 1.0);
    char key[] = "Comment";
    std::string value(5000, 'x');
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_zTXt;
    text.key = key;
    text.text = value.data();
    png_set_text(png, info, &text, 1);
}

// One byte for each sample, or two, the higher one first; libpng packs small depths.
std::vector<png_byte> row_bytes(const Samples& samples, std::size_t begin, std::size_t count,
                                int depth) {
    std::vector<png_byte> bytes;
    bytes.reserve(2 * count);
    for (std::size_t i = begin; i < begin + count; ++i) {
        if (depth == 16) bytes.push_back(static_cast<png_byte>(samples[i] >> 8U));
        bytes.push_back(static_cast<png_byte>(samples[i] & 0xffU));
    }
    return bytes;
}

}  // namespace

Samples pattern(std::size_t count, unsigned max) {
    Samples samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<std::uint16_t>((i * 7919 + i * i * 31) % (max + 1));
    return samples;
}

std::string png_bytes(const Png& picture, const Samples& samples) {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &file, append, nullptr);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, info, picture.columns, picture.rows, picture.depth, picture.colour_type,
                 picture.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!picture.palette.empty()) set_palette(png, info, picture);
    if (!picture.transparent.empty()) set_transparent(png, info, picture.transparent);
    if (picture.with_profile_and_text) set_profile_and_text(png, info);
    png_write_info(png, info);
    png_set_packing(png);
    const std::size_t row_size =
        std::size_t{picture.columns} * static_cast<std::size_t>(channels_of(picture.colour_type));
    std::vector<std::vector<png_byte>> rows;
    std::vector<png_bytep> pointers;
    rows.reserve(picture.rows);
    pointers.reserve(picture.rows);
    for (std::size_t y = 0; y < picture.rows; ++y)
        rows.push_back(row_bytes(samples, y * row_size, row_size, picture.depth));
    for (auto& row : rows) pointers.push_back(row.data());
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

std::string png_chunk(const std::string& type, const std::string& data) {
    const auto big_endian = [](std::size_t number) {
        std::string bytes;
        for (unsigned shift = 32; shift > 0; shift -= 8)
            bytes += static_cast<char>((number >> (shift - 8)) & 0xffU);
        return bytes;
    };
    const std::string body = type + data;
    const auto crc =
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<unsigned>(body.size()));
    return big_endian(data.size()) + body + big_endian(crc);
}

std::string jpeg_bytes(const Jpeg& picture, const Samples& samples) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;  // NOLINT: libjpeg's type
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = picture.columns;
    jpeg.image_height = picture.rows;
    jpeg.input_components = picture.channels;
    jpeg.in_color_space = picture.channels == 1   ? JCS_GRAYSCALE
                          : picture.channels == 3 ? JCS_RGB
                                                  : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (picture.progressive) jpeg_simple_progression(&jpeg);
    jpeg.arith_code = picture.arithmetic ? TRUE : FALSE;
    jpeg_start_compress(&jpeg, TRUE);
    if (!picture.app1.empty())
        jpeg_write_marker(&jpeg, JPEG_APP0 + 1,
                          reinterpret_cast<const JOCTET*>(picture.app1.data()),
                          static_cast<unsigned>(picture.app1.size()));
    const std::size_t row_size =
        std::size_t{picture.columns} * static_cast<std::size_t>(picture.channels);
    for (std::size_t y = 0; y < picture.rows; ++y) {
        std::vector<png_byte> bytes = row_bytes(samples, y * row_size, row_size, 8);
        JSAMPROW row = bytes.data();
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    std::string file(memory, memory + size);
    jpeg_destroy_compress(&jpeg);
    std::free(memory);
    return file;
}

namespace {

template <class Number>
std::string packed_numbers(const std::vector<Number>& values, bool big_endian) {
    std::string all;
    for (const Number value : values) {
        auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
        if (big_endian != (std::endian::native == std::endian::big))
            std::reverse(bytes.begin(), bytes.end());
        all.append(bytes.data(), bytes.size());
    }
    return all;
}

}  // namespace

std::string packed(const std::vector<float>& values, bool big_endian) {
    return packed_numbers(values, big_endian);
}
std::string packed(const std::vector<double>& values, bool big_endian) {
    return packed_numbers(values, big_endian);
}
std::string packed(const Samples& values, bool big_endian) {
    return packed_numbers(values, big_endian);
}

std::string bytes_of(const Samples& values) {
    std::string bytes;
    for (const unsigned value : values) bytes += static_cast<char>(value);
    return bytes;
}

std::string exif(int orientation, bool big_endian) {
    const auto numbers = [&](const Samples& values) { return packed(values, big_endian); };
    const auto wide = [&](std::uint16_t value) {
        return big_endian ? numbers({0, value}) : numbers({value, 0});
    };
    // Two entries: XResolution, whose value is stored elsewhere, then Orientation.
    return std::string("Exif\0\0", 6) + (big_endian ? "MM" : "II") + numbers({42}) + wide(8) +
           numbers({2}) + numbers({0x011a, 5}) + wide(1) + wide(38) + numbers({0x0112, 3}) +
           wide(1) + numbers({static_cast<std::uint16_t>(orientation), 0}) + wide(0);
}

std::string npy_bytes(const std::string& descr, const std::string& shape, const std::string& data,
                      bool fortran_order) {
    const std::string header = "{'descr': '" + descr +
                               "', 'fortran_order': " + (fortran_order ? "True" : "False") +
                               ", 'shape': " + shape + ", }\n";
    std::string bytes("\x93NUMPY\1\0", 8);
    bytes += static_cast<char>(header.size() & 0xffU);
    bytes += static_cast<char>(header.size() >> 8U);
    return bytes + header + data;
}

std::vector<std::pair<std::string, std::string>> one_of_each() {
    using namespace std::string_literals;
    const Samples twelve{0, 20, 40, 60, 80, 100, 120, 140, 160, 180, 200, 255};
    const Samples bits{0, 1, 1, 0, 1, 0, 0, 0, 1, 1, 0, 1};
    Png palette{4, 3, 8, PNG_COLOR_TYPE_PALETTE};
    palette.palette = {{0, 0, 0}, {255, 0, 0}};
    palette.palette_alpha = {128};
    Png keyed{2, 2, 8, PNG_COLOR_TYPE_RGB};
    keyed.transparent = {0, 20, 40};
    Png noted{4, 3, 8, PNG_COLOR_TYPE_GRAY};
    noted.with_profile_and_text = true;
    const std::string pixels = packed(std::vector<float>{0, 0.25F, 0.5F, 1, 2, 3}, false);
    return {
        {"grey.png", png_bytes({4, 3, 8, PNG_COLOR_TYPE_GRAY}, twelve)},
        {"bits.png", png_bytes({4, 3, 1, PNG_COLOR_TYPE_GRAY}, bits)},
        {"grey16.png", png_bytes({4, 3, 16, PNG_COLOR_TYPE_GRAY}, twelve)},
        {"rgb.png", png_bytes({2, 2, 8, PNG_COLOR_TYPE_RGB}, twelve)},
        {"rgba16.png", png_bytes({1, 3, 16, PNG_COLOR_TYPE_RGBA}, twelve)},
        {"grey_alpha.png", png_bytes({2, 3, 8, PNG_COLOR_TYPE_GRAY_ALPHA}, twelve)},
        {"interlaced.png", png_bytes({4, 3, 8, PNG_COLOR_TYPE_GRAY, true}, twelve)},
        {"palette.png", png_bytes(palette, bits)},
        {"keyed.png", png_bytes(keyed, twelve)},
        {"noted.png", png_bytes(noted, twelve)},
        {"grey.jpg", jpeg_bytes({4, 3, 1}, twelve)},
        {"rgb.jpg", jpeg_bytes({2, 2, 3}, twelve)},
        {"progressive.jpg", jpeg_bytes({2, 2, 3, true}, twelve)},
        {"exif.jpg", jpeg_bytes({2, 2, 3, false, false, exif(6, true)}, twelve)},
        {"text.pgm", "P2\n# a comment\n3 2\n255\n0 1 2\n253 254 255\n"},
        {"text.ppm", "P3 2 1 7 0 1 2 5 6 7"},
        {"bytes.pgm", "P5\n4 3\n255\n" + bytes_of(twelve)},
        {"pairs.pgm", "P5 2 3 1000 " + bytes_of({0, 1, 2, 3, 3, 0xe8, 0, 0, 0, 0, 1, 1})},
        {"bytes.ppm", "P6\n2 2\n255\n" + bytes_of(twelve)},
        {"pairs.ppm", "P6 1 2 65535 " + bytes_of(twelve)},
        {"grey.pfm", "Pf\n3 2\n-1.0\n" + pixels},
        {"rgb.pfm", "PF\n2 1\n1\n" + packed(std::vector<float>{0, 0.25F, 0.5F, 1, 2, 3}, true)},
        {"flat.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" +
                         bytes_of({128, 64, 32, 128, 0, 0, 0, 0, 1, 1, 1, 1, 9, 9, 9, 130})
                             .replace(8, 4, "\x10\x20\x30\x80")},
        {"old_runs.hdr", "#?RGBE\n\n-Y 1 +X 5\n"s + bytes_of({9, 8, 7, 129, 1, 1, 1, 4})},
        {"runs.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 9\n" +
                         bytes_of({2, 2, 0, 9, 137, 200, 4, 1, 2, 3, 4, 133, 7, 137, 0, 137, 128})},
        {"u1.npy", npy_bytes("|u1", "(4, 3)", bytes_of(twelve))},
        {"u2.npy", npy_bytes(">u2", "(3, 4)", packed(twelve, true))},
        {"f4.npy", npy_bytes("<f4", "(2, 3)", pixels)},
        {"f8.npy",
         npy_bytes("<f8", "(1, 1, 4)", packed(std::vector<double>{0.5, 0.25, 0.125, 0.5}, false))},
        {"columns.npy", npy_bytes("|u1", "(2, 2, 3)", bytes_of(twelve), true)},
    };
}

}  // namespace lacuna::pictures
