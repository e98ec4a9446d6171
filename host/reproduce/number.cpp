// Formats numbers as lines of text.
#include "reproduce/number.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna::reproduce {
namespace {

// Six digits; whole numbers without decimals.
std::string text_of(double value) {
    return fmt::format("{:.6g}", value);
}

std::string difference_of(const Number& number) {
    if (!number.published) return "-";
    if (!number.band) return fmt::format("{:.3g} times", number.here / *number.published);
    if (*number.published <= 0) return fmt::format("{:+.3g}", number.here - *number.published);
    return fmt::format("{:+.2f} %", 100 * (number.here / *number.published - 1));
}

std::string band_of(const Number& number) {
    if (!number.band) return "none";
    if (std::isinf(number.band->most))
        return fmt::format("at least {}", text_of(number.band->least));
    if (std::isinf(number.band->least))
        return fmt::format("at most {}", text_of(number.band->most));
    return fmt::format("{} to {}", text_of(number.band->least), text_of(number.band->most));
}

std::string verdict_of(const Number& number) {
    if (!number.band) return "decides nothing";
    return number.within() ? "within" : "NOT WITHIN";
}

}  // namespace

Number printed(std::string what, double published, double here, double percent) {
    return printed_about(std::move(what), published, here, published * percent / 100);
}

Number printed_about(std::string what, double published, double here, double about) {
    return {std::move(what), text_of(published), published, here,
            Band{published - about, published + about}};
}

Number in_words(std::string what, std::string words, double here, Band band) {
    return {std::move(what), fmt::format("\"{}\"", words), std::nullopt, here, band};
}

Number timing(std::string what, double published, double here) {
    return {std::move(what), text_of(published), published, here, std::nullopt};
}

std::string line_of(std::string_view item, const Number& number) {
    return fmt::format("{:<7} {:<42} paper {:<18} here {:<11} {:<10} band {}: {}", item,
                       number.what, number.paper, text_of(number.here), difference_of(number),
                       band_of(number), verdict_of(number));
}

bool all_within(std::span<const Number> numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [](const Number& number) { return number.within(); });
}

}  // namespace lacuna::reproduce
