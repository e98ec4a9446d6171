// The table of words: what options that are given as words may be, for every front end.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lacuna::options {

// A list of words. `none` is the empty list.
enum class Words {
    none,
    modes,           // in the order of Mode
    compared_modes,  // of compare
    point_modes,     // of sets without a picture
    dot_modes,       // of the dots of a picture
    metrics,         // in the order of Metric
    backends,        // with auto
    named_backends,  // without auto
    formats,         // of point files
    report_formats,  // of analyze
    chart_formats,   // of compare
    backgrounds,     // behind transparent pictures
    dot_styles,      // in which a pen draws wider dots
    papers,
    between,  // the rules for distances of classes
    figures,  // of the paper
};

std::span<const std::string_view> words_of(Words list);

bool is_among(std::string_view word, Words list);

// The value of an enum that has this name; unset if none has it.
template <class Enum>
std::optional<Enum> named(std::string_view name) {
    for (int i = 0; !name_of(static_cast<Enum>(i)).empty(); ++i)
        if (name_of(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
    return std::nullopt;
}

// The words with commas between them and "or" before the last one, for messages.
std::string listed(std::span<const std::string_view> words);
std::string listed(Words list);

}  // namespace lacuna::options
