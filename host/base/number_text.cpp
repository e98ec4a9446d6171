// Numbers as text, and texts for messages.
#include "base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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

std::string time_text(double seconds) {
    constexpr double kMinute = 60, kHour = 3600;
    std::string text;
    const auto say = [&](double number, const char* unit) {
        text.append(text.empty() ? "" : " ").append(rounded(std::round(number), 15)).append(unit);
    };
    const double minutes = std::round(seconds / kMinute);
    const double hours = std::floor(minutes / kMinute);
    if (seconds < 99.5)
        say(seconds, " s");
    else if (minutes < 100)
        say(minutes, " min");
    else
        say(hours < 10 ? hours : seconds / kHour, " h");
    if (minutes >= 100 && hours < 10 && minutes != kMinute * hours)
        say(minutes - kMinute * hours, " min");
    return text;
}

std::string shown(const std::string& text) {
    const auto is_plain = [](unsigned char c) { return c > 0x20 && c != 0x7f; };
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
    return '"' + text + '"';
}

}  // namespace lacuna
