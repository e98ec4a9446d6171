// PFM: three lines of text, then floats; the lowest row comes first.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/float_pixels.h"

namespace lacuna::pictures {
namespace {

// Takes the next word and exactly one blank after it: after the last word the floats begin.
std::string_view take_word(std::string_view& rest) {
    const std::size_t begin = rest.find_first_not_of(kBlanks);
    rest.remove_prefix(begin == std::string_view::npos ? rest.size() : begin);
    const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
    rest.remove_prefix(word.size());
    if (!rest.empty()) rest.remove_prefix(1);
    return word;
}

template <class Number>
Number take(std::string_view& rest, const Encoded& file, std::string_view what) {
    const std::string_view all = take_word(rest);
    std::string_view word = all;
    Number number{};
    if (files::take_number(word, number) != std::errc{} || !word.empty())
        file.refuse(
            fmt::format("{} of the PFM is {}: must be a number", what, files::excerpt(all)));
    return number;
}

// The sign of the scale factor says the byte order.
std::endian take_order(std::string_view& rest, const Encoded& file) {
    const auto scale = take<double>(rest, file, "the scale factor");
    if (!std::isfinite(scale) || scale == 0)
        file.refuse(
            fmt::format("the scale factor of the PFM is {}: must be finite and not 0", scale));
    return scale < 0 ? std::endian::little : std::endian::big;
}

}  // namespace

Image decode_pfm(const Encoded& file) {
    const std::size_t channels = file.bytes[1] == 'F' ? 3 : 1;
    std::string_view rest = file.bytes.substr(2);
    const auto columns = take<std::uint32_t>(rest, file, "the width");
    const auto rows = take<std::uint32_t>(rest, file, "the height");
    const Size size{columns, rows};
    const std::endian order = take_order(rest, file);
    check_size(file, size);
    const std::uint64_t wanted = size.pixels() * channels * sizeof(float);
    if (wanted > rest.size())
        file.refuse(fmt::format("{} bytes of pixels: {} are announced, {} x {} of {} floats",
                                rest.size(), wanted, columns, rows, channels));
    FloatPixels pixels(file, size, false);
    std::array<double, 3> pixel{};
    const std::span<double> used = std::span(pixel).first(channels);
    for (std::size_t y = size.rows; y-- > 0;) {
        ask_after(size.columns);
        for (std::size_t x = 0; x < size.columns; ++x) {
            for (double& value : used) {
                value = double{files::load<float>(rest, order)};
                rest.remove_prefix(sizeof(float));
            }
            pixels.set(y, x, used);
        }
    }
    return std::move(pixels).finish();
}

}  // namespace lacuna::pictures
