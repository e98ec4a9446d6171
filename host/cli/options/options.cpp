// Strict reading of numbers and domains.
#include "cli/options/options.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace lacuna::cli {
namespace {

template <class Value>
std::errc parse_whole_text(std::string_view text, Value& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc{} && stop != end) return std::errc::invalid_argument;
    return error;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// The digits of a number such as 20,000, in groups of three; empty if it is none.
std::string without_separators(std::string_view text) {
    constexpr std::string_view kSeparators = ",_' ";
    const std::size_t first = text.find_first_of(kSeparators);
    if (first == std::string_view::npos || first == 0 || first > 3 || !is_digit(text.back()))
        return "";
    std::string digits;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_separator = i >= first && (i - first) % 4 == 0;
        if (is_separator ? text[i] != text[first] : !is_digit(text[i])) return "";
        if (!is_separator) digits += text[i];
    }
    return (digits.size() - first) % 3 == 0 ? digits : "";
}

// A whole number with an exponent, or with k, M or G behind it. Doubles are exact up to 2^53.
std::optional<std::uint64_t> round_number(std::string text) {
    constexpr std::array<std::pair<char, const char*>, 4> kSuffixes{
        {{'k', "e3"}, {'K', "e3"}, {'M', "e6"}, {'G', "e9"}}};
    for (const auto& [suffix, exponent] : kSuffixes)
        if (text.ends_with(suffix)) text.replace(text.size() - 1, 1, exponent);
    double number = 0;
    if (text.empty() || !(is_digit(text.front()) || text.front() == '.') ||
        parse_whole_text(text, number) != std::errc{} || number > 0x1p53 ||
        number != std::floor(number))
        return std::nullopt;
    return static_cast<std::uint64_t>(number);
}

// web/page/command.js has the same rule, and tests/cli/whole_numbers.json tests both.
template <class Value>
void read_whole_number(const std::string& option, const std::string& text, Value& value) {
    const std::string digits = without_separators(text);
    if (parse_whole_text(digits.empty() ? text : digits, value) == std::errc{}) return;
    const std::optional<std::uint64_t> round = round_number(text);
    if (round && *round <= std::numeric_limits<Value>::max()) {
        value = static_cast<Value>(*round);
        return;
    }
    throw BadRequest(option, shown(text),
                     fmt::format("must be a whole number, such as 20000, 20,000 or 20k, at most {}",
                                 std::numeric_limits<Value>::max()));
}

}  // namespace

std::string shown(const std::string& text) {
    const bool plain = !text.empty() && text.find(' ') == std::string::npos;
    return plain && printable(text) == text ? text : fmt::format("{:?}", text);
}

// Uses fmt's escapes, which know Unicode. fmt would escape quotes and backslashes too, so the text
// is passed to it in pieces between them.
std::string printable(std::string_view text) {
    constexpr std::string_view kMayStay = "\"\\";
    std::string result;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find_first_of(kMayStay), text.size());
        const std::string quoted = fmt::format("{:?}", text.substr(0, length));
        result += quoted.substr(1, quoted.size() - 2);
        text.remove_prefix(length);
        if (text.empty()) break;
        result += text.front();
        text.remove_prefix(1);
    }
    return result;
}

void read(const std::string& option, const std::string& text, double& value) {
    const std::errc error = parse_whole_text(text, value);
    if (error == std::errc{}) return;
    throw BadRequest(option, shown(text),
                     error == std::errc::result_out_of_range
                         ? "must be a number that a double can hold"
                         : "must be a number, such as 0.01 or 1e-2");
}

void read(const std::string& option, const std::string& text, std::uint64_t& value) {
    read_whole_number(option, text, value);
}

void read(const std::string& option, const std::string& text, std::uint32_t& value) {
    read_whole_number(option, text, value);
}

void read_domain(const std::string& option, const std::string& text, double& width,
                 double& height) {
    const std::string_view view = text;
    const std::size_t cross = view.find_first_of("xX");
    if (cross == std::string_view::npos ||
        parse_whole_text(view.substr(0, cross), width) != std::errc{} ||
        parse_whole_text(view.substr(cross + 1), height) != std::errc{})
        throw BadRequest(option, shown(text),
                         "must be WIDTHxHEIGHT, two numbers such as 1x1 or 2.5x1");
}

}  // namespace lacuna::cli
