// Lengths and sheets of paper, as options give them.
#pragma once

#include <string>

namespace lacuna::cli {

struct Paper {
    double width_mm = 0;
    double height_mm = 0;
    bool may_turn = false;  // true for papers given by name

    // The paper, turned to landscape if the picture is wider than high and the paper may be turned.
    Paper suiting(double width, double height) const;
};

// A length in mm from a number with mm, cm, in or pt behind it. Throws BadRequest(option, text,
// ...) for anything else, and if the length is under least_mm or over 200 in, PDF's limit.
double read_length(const std::string& option, const std::string& text, double least_mm);

// A sheet: WIDTHxHEIGHT with one of these units, or A0 to A6, letter, legal or tabloid in any case.
// Throws as read_length does; no side may be under 1 mm.
Paper read_paper(const std::string& option, const std::string& text);

}  // namespace lacuna::cli
