// Lengths and sheets of paper, as options give them.
#pragma once

#include <lacuna/stipple.h>

#include <string>

namespace lacuna::cli {

// A length in mm from a number with mm, cm, in or pt behind it. Throws BadRequest(option, text,
// ...) for anything else, and if the length is under least_mm or over 200 in, PDF's limit.
double read_length(const std::string& option, const std::string& text, double least_mm);

// A sheet without margins: WIDTHxHEIGHT with one of these units, or A0 to A6, letter, legal or
// tabloid in any case. Papers given by name may turn. Throws as read_length does; no side may be
// under 1 mm.
Paper read_paper(const std::string& option, const std::string& text);

}  // namespace lacuna::cli
