// What the readers of the several point formats share, and their names.
#pragma once

#include <fmt/format.h>
#include <lacuna/lacuna.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

#include "files/point_files.h"
#include "files/read_sets.h"

namespace lacuna::files {

std::vector<Point> decode_lines(std::string_view bytes, bool is_csv, const std::string& name);
std::vector<Point> decode_npy(std::string_view bytes, const std::string& name);
std::vector<Point> decode_ply(std::string_view bytes, const std::string& name);
std::vector<Point> decode_json(std::string_view bytes, const std::string& name);
SetsOfFile decode_json_with_header(std::string_view bytes, const std::string& name);

// The text formats that hold a count or several sets: see read_sets.
std::vector<Point> decode_counted_lines(std::string_view bytes, const std::string& name);
std::vector<std::vector<Point>> decode_separated_lines(std::string_view bytes,
                                                       const std::string& name);

// All bytes of the file; "-" is standard input. Throws FileError.
std::string read_bytes(const std::string& path);

// What messages call the file.
std::string name_to_show(const std::string& path);

[[noreturn]] inline void refuse(const std::string& place, const std::string& why) {
    throw FileError(fmt::format("{}: {}", place, why));
}

// A piece of a file as a message shows it: quoted, escaped, and short.
inline std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    const bool is_long = text.size() > kLongest;
    return fmt::format("{:?}{}", text.substr(0, kLongest), is_long ? "..." : "");
}

inline void check_finite(Point point, std::size_t index, const std::string& name) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y))
        refuse(name, fmt::format("point {} is ({}, {}): both must be finite numbers", index,
                                 point.x, point.y));
}

// The next line, without its end; takes it from `rest`.
inline std::string_view take_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

inline void skip_blanks(std::string_view& text) {
    while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
}

// The next word, up to a blank or the end; takes it and the blanks around it from `rest`.
inline std::string_view take_word(std::string_view& rest) {
    skip_blanks(rest);
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    skip_blanks(rest);
    return word;
}

// The number that `rest` begins with; takes it from there if there is one.
template <class Number>
std::errc take_number(std::string_view& rest, Number& number) {
    std::string_view digits = rest;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc{}) rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return error;
}

// The number at the front of `bytes`, lowest byte first, on any machine.
template <class Number>
Number load_little_endian(std::string_view bytes) {
    using Bits = std::conditional_t<
        sizeof(Number) == 8, std::uint64_t,
        std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                           std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return std::bit_cast<Number>(static_cast<Bits>(bits));
}

}  // namespace lacuna::files
