// Helpers for the readers of files: refusals, lines, words and numbers.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "files/point_files.h"

namespace lacuna::files {

[[noreturn]] inline void refuse(const std::string& place, const std::string& why) {
    throw FileError(fmt::format("{}: {}", place, why));
}

// A piece of a file as a message shows it: quoted, escaped, and short.
inline std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    const bool is_long = text.size() > kLongest;
    return fmt::format("{:?}{}", text.substr(0, kLongest), is_long ? "..." : "");
}

// Removes the next line from `rest` and returns it without its line end.
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

// Removes the next word and the blanks around it from `rest`. A word ends at a blank.
inline std::string_view take_word(std::string_view& rest) {
    skip_blanks(rest);
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    skip_blanks(rest);
    return word;
}

// Reads the number at the beginning of `rest`. If there is one, it is removed from `rest`.
template <class Number>
std::errc take_number(std::string_view& rest, Number& number) {
    std::string_view digits = rest;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc{}) rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return error;
}

// The number at the beginning of `bytes`, which are in the given byte order.
template <class Number>
Number load(std::string_view bytes, std::endian order) {
    std::array<char, sizeof(Number)> own{};
    std::copy_n(bytes.begin(), own.size(), own.begin());
    if (order != std::endian::native) std::reverse(own.begin(), own.end());
    return std::bit_cast<Number>(own);
}

template <class Number>
Number load_little_endian(std::string_view bytes) {
    return load<Number>(bytes, std::endian::little);
}

}  // namespace lacuna::files
