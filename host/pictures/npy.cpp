// Reads pictures from NumPy arrays in .npy files.
#include "files/npy.h"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/polling.h"
#include "files/npy_numbers.h"
#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/float_pixels.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// An array's numbers, found by row, column and channel.
template <class Number>
class Array {
public:
    Array(std::string_view data, std::endian order, bool fortran_order, Size size,
          std::size_t channels)
        : data_(data),
          order_(order),
          row_step_(fortran_order ? 1 : size.columns * channels),
          column_step_(fortran_order ? size.rows : channels),
          channel_step_(fortran_order ? size.rows * size.columns : 1) {}

    Number at(std::size_t row, std::size_t column, std::size_t channel) const {
        const std::size_t index = row * row_step_ + column * column_step_ + channel * channel_step_;
        return files::load<Number>(data_.substr(index * sizeof(Number), sizeof(Number)), order_);
    }

private:
    std::string_view data_;
    std::endian order_;
    std::size_t row_step_;  // steps are counted in numbers
    std::size_t column_step_;
    std::size_t channel_step_;
};

struct NpyLayout {
    Size size;
    std::size_t channels;
    bool fortran_order;
};

NpyLayout layout_of(const files::NpyHeader& header, const Encoded& file) {
    const auto& shape = header.shape;
    const bool is_flat = shape.size() == 2;
    if (!is_flat && (shape.size() != 3 || (shape[2] != 1 && shape[2] != 3 && shape[2] != 4)))
        file.refuse(
            fmt::format("an array of shape {}: must be rows x columns, or rows x columns x "
                        "1, 3 or 4",
                        files::shape_text(shape)));
    const NpyLayout layout{{shape[1], shape[0]}, is_flat ? 1 : shape[2], header.fortran_order};
    check_size(file, layout.size);
    return layout;
}

template <class Number>
Image read_whole_numbers(const Encoded& file, const Array<Number>& array, const NpyLayout& layout) {
    Image image = make_image(file, layout.size);
    const std::span<double> all = image.luminance;
    constexpr std::int32_t kMax = std::numeric_limits<Number>::max();
    with_channels(static_cast<unsigned>(layout.channels), [&](auto channels) {
        for (std::size_t y = 0; y < image.rows; ++y)
            fill_row<channels>(
                all.subspan(y * image.columns, image.columns), kMax, file.reading,
                [&](std::size_t x, std::size_t c) { return std::int32_t{array.at(y, x, c)}; });
    });
    return image;
}

template <class Number>
Image read_numbers(const Encoded& file, const Array<Number>& array, const NpyLayout& layout) {
    FloatPixels pixels(file, layout.size, layout.channels == 4);
    std::array<double, 4> pixel{};
    for (std::size_t y = 0; y < layout.size.rows; ++y) {
        ask_after(layout.size.columns);
        for (std::size_t x = 0; x < layout.size.columns; ++x) {
            for (std::size_t c = 0; c < layout.channels; ++c)
                pixel[c] = files::value_of(array.at(y, x, c));
            pixels.set(y, x, std::span(pixel).first(layout.channels));
        }
    }
    return std::move(pixels).finish();
}

template <class Number>
Image read(const Encoded& file, std::string_view data, std::endian order, const NpyLayout& layout) {
    const std::uint64_t wanted = layout.size.pixels() * layout.channels * sizeof(Number);
    if (data.size() != wanted)
        file.refuse(fmt::format("{} bytes of data: {} are announced, {} x {} x {} of {}",
                                data.size(), wanted, layout.size.rows, layout.size.columns,
                                layout.channels, sizeof(Number)));
    const Array<Number> array(data, order, layout.fortran_order, layout.size, layout.channels);
    if constexpr (std::is_same_v<Number, std::uint8_t> || std::is_same_v<Number, std::uint16_t>)
        return read_whole_numbers(file, array, layout);
    else
        return read_numbers(file, array, layout);
}

}  // namespace

Image decode_npy(const Encoded& file) {
    std::string_view data = file.bytes;
    const files::NpyHeader header = files::take_npy_header(data, file.name);
    const NpyLayout layout = layout_of(header, file);
    return files::with_npy_numbers(header.descr, file.name, [&](auto number, std::endian order) {
        return read<decltype(number)>(file, data, order, layout);
    });
}

}  // namespace lacuna::pictures
