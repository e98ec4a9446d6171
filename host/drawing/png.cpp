// Writes PNG with libpng: rows of numbers, and cairo's surfaces.
#include "drawing/png.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <new>
#include <vector>

#include "base/polling.h"
#include "drawing/cairo_surface.h"
#include "drawing/picture.h"

namespace lacuna::drawing {
namespace {

// Owns what libpng needs for writing.
class Writer {
public:
    Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ != nullptr) return;
        png_destroy_write_struct(&png_, nullptr);
        throw std::bad_alloc();
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    // Calls `step` with what libpng needs. Libpng leaves it by longjmp where memory ends, so `step`
    // must not hold anything that has a destructor.
    template <class Step>
    void guarded(const Step& step) const {
        if (setjmp(png_jmpbuf(png_)) != 0) throw std::bad_alloc();
        step(png_, info_);
    }

private:
    png_structp png_;
    png_infop info_ = nullptr;
};

// Libpng calls this to write. No exception may pass through libpng, which is C. It leaves by
// longjmp only where memory ends.
void append(png_structp png, png_bytep bytes, std::size_t count) {
    try {
        static_cast<std::string*>(png_get_io_ptr(png))
            ->append(reinterpret_cast<const char*>(bytes), count);
        return;
    } catch (const std::bad_alloc&) {
    }
    png_error(png, "no memory");
}

}  // namespace

std::string encode_png(const Png& shape, const FillRow& fill) {
    std::string file;
    std::vector<std::uint8_t> row(std::size_t{shape.columns} * shape.channels * shape.bits / 8);
    const Writer writer;
    writer.guarded([&](png_structp png, png_infop info) {
        png_set_write_fn(png, &file, append, nullptr);
        png_set_IHDR(png, info, shape.columns, shape.rows, static_cast<int>(shape.bits),
                     shape.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        if (shape.pixels_per_inch) {
            const auto per_metre = static_cast<png_uint_32>(
                std::lround(*shape.pixels_per_inch * (1000 / kMillimetresPerInch)));
            png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
        }
        png_write_info(png, info);
    });
    for (std::size_t y = 0; y < shape.rows; ++y) {
        ask_after(shape.columns);
        fill(y, row);
        writer.guarded([&](png_structp png, png_infop) { png_write_row(png, row.data()); });
    }
    writer.guarded([](png_structp png, png_infop info) { png_write_end(png, info); });
    return file;
}

std::string png_of(cairo_surface_t* image, double pixels_per_inch) {
    cairo_surface_flush(image);
    check(cairo_surface_status(image));
    const bool is_grey = cairo_image_surface_get_format(image) == CAIRO_FORMAT_A8;
    const unsigned char* const pixels = cairo_image_surface_get_data(image);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image));
    const Png shape{.columns = static_cast<std::uint32_t>(cairo_image_surface_get_width(image)),
                    .rows = static_cast<std::uint32_t>(cairo_image_surface_get_height(image)),
                    .channels = is_grey ? 1U : 3U,
                    .pixels_per_inch = pixels_per_inch};
    return encode_png(shape, [&](std::size_t y, std::span<std::uint8_t> bytes) {
        const unsigned char* const row = pixels + y * stride;
        if (is_grey) {
            std::copy_n(row, bytes.size(), bytes.begin());
            return;
        }
        for (std::size_t x = 0; x < shape.columns; ++x) {
            std::uint32_t colour = 0;
            std::memcpy(&colour, row + x * sizeof colour, sizeof colour);
            for (std::size_t i = 0; i < 3; ++i)
                bytes[3 * x + i] = static_cast<std::uint8_t>(colour >> (16 - 8 * i));
        }
    });
}

}  // namespace lacuna::drawing
