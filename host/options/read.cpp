// Strict reading of numbers, domains, lengths and papers.
#include "options/read.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/number_text.h"
#include "options/words.h"

namespace lacuna::options {
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

// A whole number with an exponent, or with k, M or G behind it. Doubles are exact up to
// 2^53. 10.000 is none: it is ten to some readers and ten thousand to others.
std::optional<std::uint64_t> round_number(std::string text) {
    constexpr std::array<std::pair<char, const char*>, 4> kSuffixes{
        {{'k', "e3"}, {'K', "e3"}, {'M', "e6"}, {'G', "e9"}}};
    for (const auto& [suffix, exponent] : kSuffixes)
        if (text.ends_with(suffix)) text.replace(text.size() - 1, 1, exponent);
    const std::size_t thousands = text.size() - std::min<std::size_t>(text.size(), 4);
    const bool is_unclear = text[thousands] == '.' && text.find_first_of("eE") == std::string::npos;
    double number = 0;
    if (text.empty() || is_unclear || !(is_digit(text.front()) || text.front() == '.') ||
        parse_whole_text(text, number) != std::errc{} || number > 0x1p53 ||
        number != std::floor(number))
        return std::nullopt;
    return static_cast<std::uint64_t>(number);
}

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
                     "must be a whole number, such as 20000, 20,000 or 20k, at most " +
                         std::to_string(std::numeric_limits<Value>::max()));
}

constexpr double kInch = 25.4;          // mm
constexpr double kPoint = kInch / 72;   // mm
constexpr double kLongestInches = 200;  // PDF 1.7, annex C.2
constexpr double kLeastSide = 1;        // mm

struct Unit {
    std::string_view name;
    double size;
};

constexpr std::array<Unit, 4> kUnits{{{"mm", 1}, {"cm", 10}, {"in", kInch}, {"pt", kPoint}}};
constexpr std::array<Unit, 3> kTimes{{{"s", 1}, {"min", 60}, {"h", 3600}}};

struct PaperSize {
    double width_mm;
    double height_mm;
};

// The sizes of the papers in Words::papers, in the same order: ISO 216 first, then ANSI, whose
// sides are whole or half inches.
constexpr std::array<PaperSize, 10> kSizes{{{841, 1189},
                                            {594, 841},
                                            {420, 594},
                                            {297, 420},
                                            {210, 297},
                                            {148, 210},
                                            {105, 148},
                                            {215.9, 279.4},
                                            {215.9, 355.6},
                                            {279.4, 431.8}}};

bool is_same_word(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

// Takes the unit from the end of `text`; returns its size.
std::optional<double> take_unit(std::string_view& text, std::span<const Unit> units = kUnits) {
    for (const Unit& unit : units) {
        if (!text.ends_with(unit.name)) continue;
        text.remove_suffix(unit.name.size());
        return unit.size;
    }
    return std::nullopt;
}

// What `text` gives in units of this size. Unset if `text` is not one number.
std::optional<double> length_of(std::string_view text, double unit) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double number = 0;
    if (parse_whole_text(text, number) != std::errc{}) return std::nullopt;
    return number * unit;
}

void check_length(const std::string& option, const std::string& text, double mm, double least_mm) {
    if (!(mm >= least_mm && mm <= kLongestInches * kInch))
        throw BadRequest(
            option, shown(text),
            "must be " + shortest(least_mm) + "mm to " + shortest(kLongestInches) + "in long");
}

}  // namespace

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

std::vector<std::string> parts_of_list(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, comma - begin));
        begin = comma + 1;
    }
    return parts;
}

void read_domain(const std::string& option, const std::string& text, Domain& domain) {
    const auto refuse = [&] {
        throw BadRequest(option, shown(text),
                         "must be WIDTHxHEIGHT of a flat domain, two numbers such as 1x1 or "
                         "2.5x1, or X0,Y0+WIDTHxHEIGHT with the lower left corner, such as "
                         "448000,5411000+2000x1500");
    };
    std::string_view view = text;
    const auto take_until = [&](std::string_view ends, std::size_t from, double& value) {
        const std::size_t end = view.find_first_of(ends, from);
        if (end == std::string_view::npos ||
            parse_whole_text(view.substr(0, end), value) != std::errc{})
            refuse();
        view.remove_prefix(end + 1);
    };
    domain.x0 = domain.y0 = 0;
    if (view.find(',') != std::string_view::npos) {
        take_until(",", 0, domain.x0);
        // A plus sign behind an e belongs to the number.
        std::size_t plus = view.find('+');
        while (plus != 0 && plus != std::string_view::npos &&
               (view[plus - 1] == 'e' || view[plus - 1] == 'E'))
            plus = view.find('+', plus + 1);
        take_until("+", std::min(plus, view.size()), domain.y0);
    }
    take_until("xX", 0, domain.width);
    if (parse_whole_text(view, domain.height) != std::errc{}) refuse();
}

bool parse_raster(std::string_view text, Raster& raster) {
    const std::size_t cross = text.find('x');
    return cross != std::string_view::npos &&
           parse_whole_text(text.substr(0, cross), raster.columns) == std::errc{} &&
           parse_whole_text(text.substr(cross + 1), raster.rows) == std::errc{};
}

void read_raster(const std::string& option, const std::string& text, Raster& raster) {
    if (!parse_raster(text, raster))
        throw BadRequest(option, shown(text), "must be COLUMNSxROWS in pixels, such as 512x80");
}

void read_background(const std::string& text, Tone& tone) {
    if (!is_among(text, Words::backgrounds))
        throw BadRequest("background", shown(text), "must be " + listed(Words::backgrounds));
    tone.on_black = text == "black";
}

void read_crop(const std::string& text, Tone& tone) {
    std::array<std::uint32_t, 4> numbers{};
    const std::vector<std::string> parts = parts_of_list(text);
    bool are_numbers = parts.size() == numbers.size();
    for (std::size_t i = 0; are_numbers && i < numbers.size(); ++i)
        are_numbers = parse_whole_text(parts[i], numbers[i]) == std::errc{};
    tone.crop = {numbers[0], numbers[1], numbers[2], numbers[3]};
    if (!are_numbers || tone.crop.columns == 0 || tone.crop.rows == 0)
        throw BadRequest("crop", shown(text),
                         "must be LEFT,TOP,WIDTH,HEIGHT in pixels, such as 100,50,640,480");
}

void read_sharpen(const std::string& text, Tone& tone) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    read("sharpen", text.substr(0, colon), tone.sharpen);
    if (colon != text.size()) read("sharpen", text.substr(colon + 1), tone.sharpen_amount);
}

double read_length(const std::string& option, const std::string& text, double least_mm) {
    std::string_view rest = text;
    const std::optional<double> unit = take_unit(rest);
    const std::optional<double> mm = unit ? length_of(rest, *unit) : std::nullopt;
    if (!mm)
        throw BadRequest(option, shown(text),
                         "must be a number and mm, cm, in or pt, such as 0.5mm");
    check_length(option, text, *mm, least_mm);
    return *mm;
}

double read_time(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const std::optional<double> unit = take_unit(rest, kTimes);
    const std::optional<double> seconds = unit ? length_of(rest, *unit) : std::nullopt;
    if (!seconds || !(*seconds > 0))
        throw BadRequest(option, shown(text),
                         "must be a number over 0 and s, min or h, such as 90min or 1.5h");
    return *seconds;
}

std::optional<Pens> read_pens(const std::string& option, const std::string& text, bool has_tones) {
    if (text == "radius") return std::nullopt;
    const std::size_t dots = has_tones ? text.find("..") : std::string::npos;
    const double least = read_length(option, text.substr(0, dots), kLeastDot);
    if (dots == std::string::npos) return Pens{least, least};
    const double most = read_length(option, text.substr(dots + 2), kLeastDot);
    if (!(least <= most)) throw BadRequest(option, shown(text), "the first must not be the larger");
    return Pens{least, most};
}

Pens read_pens_there_are(const std::string& option, const std::string& text) {
    std::vector<double> widths;
    for (const std::string& part : parts_of_list(text))
        widths.push_back(read_length(option, part, kLeastDot));
    std::sort(widths.begin(), widths.end());
    widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
    const double least = widths.front(), most = widths.back();
    return {least, most, std::move(widths)};
}

Paper read_paper(const std::string& option, const std::string& text) {
    const auto names = words_of(Words::papers);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (is_same_word(text, names[i]))
            return {.width_mm = kSizes.at(i).width_mm,
                    .height_mm = kSizes.at(i).height_mm,
                    .may_turn = true};

    std::string_view rest = text;
    const std::optional<double> unit = take_unit(rest);
    const std::size_t cross = rest.find('x');
    std::optional<double> width, height;
    if (unit && cross != std::string_view::npos) {
        width = length_of(rest.substr(0, cross), *unit);
        height = length_of(rest.substr(cross + 1), *unit);
    }
    if (!width || !height)
        throw BadRequest(
            option, shown(text),
            "must be A0 to A6, letter, legal or tabloid, or WIDTHxHEIGHT and mm, cm, in "
            "or pt, such as 210x297mm");
    check_length(option, text, *width, kLeastSide);
    check_length(option, text, *height, kLeastSide);
    return {.width_mm = *width, .height_mm = *height};
}

}  // namespace lacuna::options
