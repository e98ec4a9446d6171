// Values of options from texts, read strictly: a text that is not a value as a whole is refused.
#pragma once

#include <lacuna/stipple.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::options {

// Each throws BadRequest(option, text, what is allowed). The library checks ranges.
void read(const std::string& option, const std::string& text, double& value);
// Whole numbers may be 20000, 2e4, 20k or 1.5M, and 20,000 with a comma, an underscore, an
// apostrophe or a blank between groups of three digits.
void read(const std::string& option, const std::string& text, std::uint64_t& value);
void read(const std::string& option, const std::string& text, std::uint32_t& value);

template <class Value>
void read(const std::string& option, const std::string& text, std::optional<Value>& value) {
    read(option, text, value.emplace());
}

// What lies between the commas of a list.
std::vector<std::string> parts_of_list(const std::string& text);

// The sides of a domain as WIDTHxHEIGHT.
void read_domain(const std::string& option, const std::string& text, Domain& domain);

// Columns and rows of pixels as COLUMNSxROWS; parse_raster returns whether the text is that.
bool parse_raster(std::string_view text, Raster& raster);
void read_raster(const std::string& option, const std::string& text, Raster& raster);

// white or black: Tone::on_black.
void read_background(const std::string& text, Tone& tone);

// LEFT,TOP,WIDTH,HEIGHT in pixels.
void read_crop(const std::string& text, Tone& tone);

// R:X, a radius in pixels and how much edges are sharpened; or R alone.
void read_sharpen(const std::string& text, Tone& tone);

// A length in mm from a number with mm, cm, in or pt behind it. Throws BadRequest(option, text,
// ...) for anything else, and if the length is under least_mm or over 200 in, PDF's limit.
double read_length(const std::string& option, const std::string& text, double least_mm);

// The least diameter of dots, and width of pens, in mm.
inline constexpr double kLeastDot = 0.001;

// A time in seconds, over 0, from a number with s, min or h behind it. Throws as read_length does.
double read_time(const std::string& option, const std::string& text);

// The diameter of dots in such a unit; if `has_tones`, two diameters may have `..` between them.
// Unset for the word "radius".
std::optional<Pens> read_pens(const std::string& option, const std::string& text, bool has_tones);

// The widths of pens, with commas between them.
Pens read_pens_there_are(const std::string& option, const std::string& text);

// A sheet without margins: WIDTHxHEIGHT with one of these units, or A0 to A6, letter, legal or
// tabloid in any case. Papers given by name may turn. Throws as read_length does; no side may be
// under 1 mm.
Paper read_paper(const std::string& option, const std::string& text);

}  // namespace lacuna::options
