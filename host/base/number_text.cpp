// Numbers as text.
#include "base/number_text.h"

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

}  // namespace lacuna
