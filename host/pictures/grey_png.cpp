// Writes PNG with libpng.
#include "pictures/grey_png.h"

#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <new>
#include <vector>

namespace lacuna::pictures {

std::string grey_png(std::uint32_t columns, unsigned bits, std::span<const std::uint16_t> values) {
    const std::size_t bytes_a_row = std::size_t{columns} * bits / 8;
    const auto rows = static_cast<std::uint32_t>(values.size() / columns);
    std::vector<std::uint8_t> pixels;  // the higher byte first
    pixels.reserve(rows * bytes_a_row);
    for (const std::uint16_t value : values) {
        if (bits == 16) pixels.push_back(static_cast<std::uint8_t>(value >> 8U));
        pixels.push_back(static_cast<std::uint8_t>(value & 0xffU));
    }
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) {
        png_destroy_write_struct(&png, nullptr);
        throw std::bad_alloc();
    }
    // No exception may pass through libpng, which is C. It leaves by longjmp only where memory
    // ends.
    const auto append = [](png_structp writer, png_bytep bytes, std::size_t count) {
        try {
            static_cast<std::string*>(png_get_io_ptr(writer))
                ->append(reinterpret_cast<const char*>(bytes), count);
            return;
        } catch (const std::bad_alloc&) {
        }
        png_error(writer, "no memory");
    };
    if (setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_write_struct(&png, &info);
        throw std::bad_alloc();
    }
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, columns, rows, static_cast<int>(bits), PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (std::uint32_t y = 0; y < rows; ++y) png_write_row(png, pixels.data() + y * bytes_a_row);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

}  // namespace lacuna::pictures
