// A number of the paper beside the same number made here, and how far apart they may be.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lacuna::reproduce {

struct Band {
    double least;
    double most;  // included, like the least
};

struct Number {
    std::string what;
    std::string paper;                // as the paper gives it, in figures or in words
    std::optional<double> published;  // none where the paper says it in words
    double here;
    std::optional<Band> band;  // none: told for comparison, decides nothing

    bool within() const { return !band || (here >= band->least && here <= band->most); }
};

// Within so many percent of what the paper prints.
Number printed(std::string what, double published, double here, double percent);
// Within so much of it.
Number printed_about(std::string what, double published, double here, double about);
// What the paper says in words, turned into a number and the band in which the words hold.
Number in_words(std::string what, std::string words, double here, Band band);
// Seconds, which depend on the machine.
Number timing(std::string what, double published, double here);

// One line, without its end: name, what, paper, here, difference, band, within it or not.
std::string line_of(std::string_view item, const Number& number);

bool all_within(std::span<const Number> numbers);

}  // namespace lacuna::reproduce
