// The inks that a text names.
#include <fmt/core.h>
#include <lacuna/pictures.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "options/read.h"

namespace lacuna {
namespace {

struct Named {
    std::string_view name;
    Colour colour;
};

// The inks of offset printing (ISO 12647-2) on coated paper, as sRGB shows them.
constexpr std::array<Named, 4> kCmyk{{{"cyan", {0x00, 0x9e, 0xe3}},
                                      {"magenta", {0xe6, 0x00, 0x7e}},
                                      {"yellow", {0xff, 0xed, 0x00}},
                                      {"black", {0x1d, 0x1d, 0x1b}}}};
constexpr std::array<Named, 18> kPens{{{"black", {0x00, 0x00, 0x00}},
                                       {"grey", {0x80, 0x80, 0x80}},
                                       {"white", {0xff, 0xff, 0xff}},
                                       {"red", {0xe0, 0x10, 0x20}},
                                       {"orange", {0xff, 0x80, 0x00}},
                                       {"yellow", {0xff, 0xed, 0x00}},
                                       {"green", {0x00, 0x96, 0x40}},
                                       {"cyan", {0x00, 0x9e, 0xe3}},
                                       {"turquoise", {0x00, 0xa8, 0xa0}},
                                       {"blue", {0x00, 0x40, 0xc0}},
                                       {"navy", {0x10, 0x20, 0x60}},
                                       {"purple", {0x80, 0x20, 0xa0}},
                                       {"magenta", {0xe6, 0x00, 0x7e}},
                                       {"pink", {0xff, 0x80, 0xb0}},
                                       {"brown", {0x80, 0x48, 0x20}},
                                       {"copper", {0xb8, 0x73, 0x33}},
                                       {"gold", {0xd4, 0xaf, 0x37}},
                                       {"silver", {0xc0, 0xc0, 0xc0}}}};
constexpr std::size_t kMostInks = 16;

std::string names_of_pens() {
    std::string names;
    for (const Named& pen : kPens) names += fmt::format("{}, ", pen.name);
    return names;
}

[[noreturn]] void refuse(std::string_view text) {
    throw BadRequest("inks", fmt::format("{:?}", text),
                     fmt::format("must be cmyk, or up to {} different inks separated by commas: "
                                 "{}#rrggbb or NAME=#rrggbb; each may have a pen, "
                                 "as in black:0.3mm",
                                 kMostInks, names_of_pens()));
}

std::optional<Colour> colour_of(std::string_view text) {
    constexpr std::size_t kLength = 7;
    if (text.size() != kLength || text[0] != '#') return std::nullopt;
    Colour colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        const char* const digits = text.data() + 1 + 2 * i;
        const auto [end, error] = std::from_chars(digits, digits + 2, colour[i], 16);
        if (error != std::errc{} || end != digits + 2) return std::nullopt;
    }
    return colour;
}

// Names become labels of layers and words in .csv, so they hold no character with a meaning there.
bool is_name(std::string_view name) {
    constexpr std::size_t kLongest = 40;
    return !name.empty() && name.size() <= kLongest &&
           std::all_of(name.begin(), name.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || c == '#';
           });
}

// Takes the width of a pen from the end of `text`, where it follows a colon; 0 without one.
double take_width(std::string_view& text) {
    constexpr double kLeast = 0.001;  // mm
    const std::size_t colon = std::min(text.rfind(':'), text.size());
    const std::string_view width = text.substr(std::min(colon + 1, text.size()));
    if (colon == text.size()) return 0;
    text = text.substr(0, colon);
    return options::read_length("inks", std::string(width), kLeast);
}

std::optional<Ink> ink_of(std::string_view word) {
    for (const Named& pen : kPens)
        if (pen.name == word) return Ink{std::string(word), pen.colour};
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(0, equals);
    const std::optional<Colour> colour =
        colour_of(equals == std::string_view::npos ? word : word.substr(equals + 1));
    if (!colour || !is_name(name)) return std::nullopt;
    return Ink{std::string(name), *colour};
}

}  // namespace

Colour paper_of(const std::string& text) {
    const std::optional<Ink> ink =
        text.find('=') == std::string::npos ? ink_of(text) : std::nullopt;
    if (!ink)
        throw BadRequest("paper-colour", fmt::format("{:?}", text),
                         fmt::format("must be {}or #rrggbb", names_of_pens()));
    return ink->colour;
}

std::vector<Ink> inks_of(const std::string& text) {
    std::vector<Ink> inks;
    std::string_view word = text;
    if (const double pen_mm = word.starts_with("cmyk") ? take_width(word) : 0; word == "cmyk") {
        for (const Named& ink : kCmyk) inks.push_back({std::string(ink.name), ink.colour, pen_mm});
        return inks;
    }
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        word = rest.substr(0, comma);
        const double pen_mm = take_width(word);
        std::optional<Ink> ink = ink_of(word);
        const auto has_its_name = [&](const Ink& other) { return other.name == ink->name; };
        if (!ink || std::any_of(inks.begin(), inks.end(), has_its_name) || inks.size() == kMostInks)
            refuse(text);
        inks.push_back(std::move(*ink));
        inks.back().pen_mm = pen_mm;
        if (comma == std::string_view::npos) return inks;
        rest.remove_prefix(comma + 1);
    }
}

}  // namespace lacuna
