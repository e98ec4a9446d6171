// Numbers as text, and texts for messages.
#include "base/number_text.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace lacuna {

std::string shortest(double value) {
    char digits[32];
    const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
    return {digits, end};
}

std::string rounded(double value, int digits) {
    char text[32];
    const auto end =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, digits)
            .ptr;
    return {text, end};
}

std::string shown(const std::string& text) {
    const auto is_plain = [](unsigned char c) { return c > 0x20 && c != 0x7f; };
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
    return '"' + text + '"';
}

}  // namespace lacuna
