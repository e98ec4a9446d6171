// Units of length, and the names and sizes of papers.
#include "cli/options/options.h"

#include <fmt/core.h>

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

#include "drawing/picture.h"
#include "files/parse.h"
#include "files/point_files.h"
#include "recipes/words.h"

namespace lacuna::cli {
namespace {

constexpr double kLongestInches = 200;  // PDF 1.7, annex C.2
constexpr double kLeastSide = 1;        // mm

struct Unit {
    std::string_view name;
    double mm;
};

constexpr std::array<Unit, 4> kUnits{
    {{"mm", 1},
     {"cm", 10},
     {"in", drawing::kMillimetresPerInch},
     {"pt", drawing::kMillimetresPerInch / drawing::kPointsPerInch}}};

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

std::string in_lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(), files::lower_case);
    return lower;
}

// Takes the unit from the end of `text`.
std::optional<double> take_unit(std::string_view& text) {
    for (const Unit& unit : kUnits) {
        if (!text.ends_with(unit.name)) continue;
        text.remove_suffix(unit.name.size());
        return unit.mm;
    }
    return std::nullopt;
}

// The length in mm that `text` gives in units of `unit_mm`. Unset if `text` is not one number.
std::optional<double> length_of(std::string_view text, double unit_mm) {
    double number = 0;
    if (files::take_number(text, number) != std::errc{} || !text.empty()) return std::nullopt;
    return number * unit_mm;
}

void check_length(const std::string& option, const std::string& text, double mm, double least_mm) {
    if (!(mm >= least_mm && mm <= kLongestInches * drawing::kMillimetresPerInch))
        throw BadRequest(option, shown(text),
                         fmt::format("must be {}mm to {}in long", least_mm, kLongestInches));
}

}  // namespace

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

Paper read_paper(const std::string& option, const std::string& text) {
    const auto names = recipes::words_of(recipes::Words::papers);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (in_lower_case(text) == in_lower_case(names[i]))
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

}  // namespace lacuna::cli
