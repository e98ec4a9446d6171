// Reads pictures from NumPy arrays in .npy files.
#include "files/npy.h"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/float_pixels.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// NumPy's bool: one byte, 0 or 1.
struct Bool {
    std::uint8_t byte;
};

// IEEE 754's binary16: a sign, 5 bits of exponent and 10 bits of fraction.
struct Half {
    std::uint16_t bits;
};

double value_of(Bool value) {
    return value.byte == 0 ? 0 : 1;
}

double value_of(Half half) {
    const auto exponent = static_cast<int>(half.bits >> 10U & 0x1fU);
    const double fraction = half.bits & 0x3ffU;
    constexpr int kSpecial = 0x1f, kBias = 15, kFractionBits = 10;
    double value = 0;
    if (exponent == kSpecial)
        value = fraction == 0 ? std::numeric_limits<double>::infinity()
                              : std::numeric_limits<double>::quiet_NaN();
    else if (exponent == 0)
        value = std::ldexp(fraction, 1 - kBias - kFractionBits);
    else
        value = std::ldexp(fraction + 1024, exponent - kBias - kFractionBits);
    return (half.bits & 0x8000U) != 0 ? -value : value;
}

// Whole numbers over 2^53 lose their last digits, which do not matter for a tone.
template <class Number>
double value_of(Number value) {
    return static_cast<double>(value);
}

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
    for (std::size_t y = 0; y < layout.size.rows; ++y)
        for (std::size_t x = 0; x < layout.size.columns; ++x) {
            for (std::size_t c = 0; c < layout.channels; ++c)
                pixel[c] = value_of(array.at(y, x, c));
            pixels.set(y, x, std::span(pixel).first(layout.channels));
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
    const std::string_view type = header.descr;
    const std::endian order = type.starts_with('>') ? std::endian::big : std::endian::little;
    if (type == "|u1") return read<std::uint8_t>(file, data, order, layout);
    if (type == "<u2" || type == ">u2") return read<std::uint16_t>(file, data, order, layout);
    if (type == "|b1") return read<Bool>(file, data, order, layout);
    if (type == "|i1") return read<std::int8_t>(file, data, order, layout);
    if (type == "<i2" || type == ">i2") return read<std::int16_t>(file, data, order, layout);
    if (type == "<i4" || type == ">i4") return read<std::int32_t>(file, data, order, layout);
    if (type == "<u4" || type == ">u4") return read<std::uint32_t>(file, data, order, layout);
    if (type == "<i8" || type == ">i8") return read<std::int64_t>(file, data, order, layout);
    if (type == "<u8" || type == ">u8") return read<std::uint64_t>(file, data, order, layout);
    if (type == "<f2" || type == ">f2") return read<Half>(file, data, order, layout);
    if (type == "<f4" || type == ">f4") return read<float>(file, data, order, layout);
    if (type == "<f8" || type == ">f8") return read<double>(file, data, order, layout);
    file.refuse(
        fmt::format("numbers of type {}: must be b1, i1 to i8, u1 to u8 or f2 to f8 (bool, int8 "
                    "to uint64, float16 to float64)",
                    files::excerpt(type)));
}

}  // namespace lacuna::pictures
