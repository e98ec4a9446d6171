// The lists of words, and the names of modes and metrics, which are among them.
#include "options/words.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace lacuna::options {
namespace {

using Word = std::string_view;

constexpr std::array<Word, 5> kModes{"exact", "lines", "cells", "stratified", "pixels"};
constexpr std::array<Word, 3> kPointModes{"exact", "lines", "stratified"};
constexpr std::array<Word, 3> kDotModes{"stratified", "cells", "exact"};
constexpr std::array<Word, 3> kMetrics{"min", "mean", "max"};
constexpr std::array<Word, 5> kBackends{"auto", "cpu", "opencl", "vulkan", "reference"};
constexpr std::array<Word, 9> kFormats{"txt",  "csv", "npy", "ply", "geojson",
                                       "json", "svg", "pdf", "png"};
constexpr std::array<Word, 10> kPapers{"A0", "A1", "A2",     "A3",    "A4",
                                       "A5", "A6", "letter", "legal", "tabloid"};
constexpr std::array<Word, 2> kBackgrounds{"white", "black"};
constexpr std::array<Word, 2> kDotStyles{"spiral", "circle"};
constexpr std::array<Word, 2> kBetween{"sum", "union"};
constexpr std::array<Word, 9> kFigures{"table1", "table2", "fig3", "fig4", "fig5",
                                       "fig6",   "fig7",   "fig8", "all"};

}  // namespace

std::span<const Word> words_of(Words list) {
    const std::span<const Word> modes = kModes;
    const std::span<const Word> backends = kBackends;
    const std::span<const Word> formats = kFormats;
    switch (list) {
        case Words::none:
            return {};
        case Words::modes:
            return modes;
        case Words::compared_modes:
            return modes.first(4);
        case Words::point_modes:
            return kPointModes;
        case Words::dot_modes:
            return kDotModes;
        case Words::metrics:
            return kMetrics;
        case Words::backends:
            return backends;
        case Words::named_backends:
            return backends.subspan(1);
        case Words::formats:
            return formats;
        case Words::report_formats:
            return formats.subspan(5);
        case Words::chart_formats:
            return formats.subspan(6);
        case Words::backgrounds:
            return kBackgrounds;
        case Words::dot_styles:
            return kDotStyles;
        case Words::papers:
            return kPapers;
        case Words::between:
            return kBetween;
        case Words::figures:
            return kFigures;
    }
    return {};
}

bool is_among(std::string_view word, Words list) {
    const std::span<const Word> words = words_of(list);
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string listed(std::span<const Word> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i != 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

std::string listed(Words list) {
    return listed(words_of(list));
}

}  // namespace lacuna::options

namespace lacuna {

namespace {

// The word of an enum; empty for a number that is none of its values.
template <typename Enum>
std::string_view word_of(std::span<const std::string_view> words, Enum value) {
    const auto place = static_cast<std::size_t>(value);
    return place < words.size() ? words[place] : std::string_view{};
}

}  // namespace

std::string_view name_of(Mode mode) {
    return word_of(options::kModes, mode);
}

std::string_view name_of(Metric metric) {
    return word_of(options::kMetrics, metric);
}

}  // namespace lacuna
