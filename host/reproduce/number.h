// A number of the paper, the same number made here, and how far apart they may be.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lacuna::reproduce {

struct Band {
    double least;
    double most;  // the band includes both ends
};

struct Number {
    std::string what;
    std::string paper;                // as the paper gives it, in digits or in words
    std::optional<double> published;  // empty if the paper says it in words
    double here;
    std::optional<Band> band;  // empty: for information only, never a failure

    bool within() const { return !band || (here >= band->least && here <= band->most); }
};

// Passes within `percent` percent of the published number.
Number printed(std::string what, double published, double here, double percent);
// Passes within `about` of the published number.
Number printed_about(std::string what, double published, double here, double about);
// A statement of the paper as a number, and the band in which the statement holds.
Number in_words(std::string what, std::string words, double here, Band band);
// Seconds. They depend on the machine and never fail.
Number timing(std::string what, double published, double here);

// One line without its end: item, what, paper, here, difference, band, whether it is in the band.
std::string line_of(std::string_view item, const Number& number);

bool all_within(std::span<const Number> numbers);

}  // namespace lacuna::reproduce
