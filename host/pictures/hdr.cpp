// Radiance HDR: each pixel has three mantissas and a common exponent, usually run-length coded.
// Follows freadcolrs and oldreadcolrs in Radiance's src/common/color.c.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/float_pixels.h"

namespace lacuna::pictures {
namespace {

using Byte = std::uint8_t;
using Pixel = std::array<Byte, 4>;

// Takes "-Y rows +X columns".
std::optional<Size> take_size(std::string_view line) {
    Size size{};
    if (files::take_word(line) != "-Y" || files::take_number(line, size.rows) != std::errc{})
        return std::nullopt;
    if (files::take_word(line) != "+X" || files::take_number(line, size.columns) != std::errc{})
        return std::nullopt;
    if (!line.empty()) return std::nullopt;
    return size;
}

struct Header {
    Size size{};
    bool is_xyz = false;  // Y, the luminance, is stored in the channel of green
};

Header take_header(std::string_view& rest, const Encoded& file) {
    Header header;
    for (;;) {
        if (rest.empty()) file.refuse("ends in its header, before an empty line");
        const std::string_view line = files::take_line(rest);
        if (line.empty()) break;
        if (!line.starts_with("FORMAT=")) continue;
        header.is_xyz = line == "FORMAT=32-bit_rle_xyze";
        if (!header.is_xyz && line != "FORMAT=32-bit_rle_rgbe")
            file.refuse(fmt::format("{}: must be 32-bit_rle_rgbe or 32-bit_rle_xyze",
                                    files::excerpt(line)));
    }
    const std::string_view line = files::take_line(rest);
    const std::optional<Size> size = take_size(line);
    if (!size)
        file.refuse(fmt::format("the size is given as {}: must be as in -Y 480 +X 640",
                                files::excerpt(line)));
    header.size = *size;
    return header;
}

// Reads a picture row by row.
class RowReader {
public:
    RowReader(const Encoded& file, std::string_view bytes) : file_(file), rest_(bytes) {}

    void read(std::size_t y, std::span<Pixel> row) {
        y_ = y;
        // The mark of a row of channels. No pixel has mantissas this small, so none begins with it.
        if (row.size() >= 8 && row.size() < 0x8000 && rest_.size() >= 4 && byte(0) == 2 &&
            byte(1) == 2 && byte(2) < 0x80)
            read_by_channel(row);
        else
            read_by_pixel(row);
    }

private:
    Byte byte(std::size_t i) const { return static_cast<Byte>(rest_[i]); }

    [[noreturn]] void refuse(std::string_view why) const {
        file_.refuse(fmt::format("not a whole Radiance HDR: row {}, counted from 0, {}", y_, why));
    }

    void need(std::size_t count) const {
        if (rest_.size() < count) refuse("is cut off");
    }

    // Reads a row in which each channel is run-length coded separately.
    void read_by_channel(std::span<Pixel> row) {
        if (row.size() != byte(2) * 256U + byte(3)) refuse("is of another width than the picture");
        rest_.remove_prefix(4);
        for (std::size_t channel = 0; channel < 4; ++channel)
            for (std::size_t x = 0; x < row.size();) x += read_run(row.subspan(x), channel);
    }

    // Reads a run of equal numbers, or several different ones. Returns how many.
    std::size_t read_run(std::span<Pixel> row, std::size_t channel) {
        constexpr std::size_t kEqual = 128;
        need(2);
        const std::size_t code = byte(0);
        const bool are_equal = code > kEqual;
        const std::size_t count = are_equal ? code - kEqual : code;
        if (count == 0 || count > row.size()) refuse("has a run that does not fit");
        need(are_equal ? 2 : 1 + count);
        for (std::size_t i = 0; i < count; ++i) row[i][channel] = byte(are_equal ? 1 : 1 + i);
        rest_.remove_prefix(are_equal ? 2 : 1 + count);
        return count;
    }

    // Reads a row pixel by pixel. The pixel 1, 1, 1, n repeats the previous pixel n times. If such
    // pixels follow each other, the k-th of them, from k = 0, repeats it n * 256^k times.
    void read_by_pixel(std::span<Pixel> row) {
        unsigned shift = 0;
        for (std::size_t x = 0; x < row.size();) {
            need(4);
            const Pixel pixel{byte(0), byte(1), byte(2), byte(3)};
            rest_.remove_prefix(4);
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                row[x++] = pixel;
                shift = 0;
                continue;
            }
            const std::size_t count = shift > 24 ? 0 : std::size_t{pixel[3]} << shift;
            if (x == 0 || count == 0 || count > row.size() - x)
                refuse("has a run that does not fit");
            for (const std::size_t end = x + count; x < end; ++x) row[x] = row[x - 1];
            shift += 8;
        }
    }

    const Encoded& file_;
    std::string_view rest_;
    std::size_t y_ = 0;
};

// The mantissas are in units of 1/256.
std::array<double, 3> to_doubles(const Pixel& pixel) {
    if (pixel[3] == 0) return {};
    const double unit = std::ldexp(1.0, int{pixel[3]} - (128 + 8));
    return {pixel[0] * unit, pixel[1] * unit, pixel[2] * unit};
}

}  // namespace

Image decode_hdr(const Encoded& file) {
    std::string_view rest = file.bytes;
    const Header header = take_header(rest, file);
    check_size(file, header.size);
    // A row takes at least one pixel, which has four bytes.
    if (header.size.rows > rest.size() / 4)
        file.refuse(fmt::format("not a whole Radiance HDR: {} bytes cannot hold {} x {} pixels",
                                rest.size(), header.size.columns, header.size.rows));
    FloatPixels pixels(file, header.size, false);
    std::vector<Pixel> row(header.size.columns);
    RowReader reader(file, rest);
    for (std::size_t y = 0; y < header.size.rows; ++y) {
        ask_after(row.size());
        reader.read(y, row);
        for (std::size_t x = 0; x < row.size(); ++x) {
            const std::array<double, 3> colour = to_doubles(row[x]);
            pixels.set(y, x, header.is_xyz ? std::span(colour).subspan(1, 1) : std::span(colour));
        }
    }
    return std::move(pixels).finish();
}

}  // namespace lacuna::pictures
