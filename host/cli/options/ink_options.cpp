// Reads and checks the options of inks, and separates the picture.
#include "cli/options/ink_options.h"

#include <fmt/core.h>
#include <lacuna/pictures.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "cli/options/options.h"
#include "pictures/image.h"
#include "pictures/importance.h"
#include "plan/plan.h"

namespace lacuna::cli {
namespace {

std::vector<std::uint64_t> read_counts(const std::string& text) {
    std::vector<std::uint64_t> counts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        read("ink-counts", text.substr(begin, comma - begin), counts.emplace_back());
        begin = comma + 1;
    }
    return counts;
}

std::uint64_t sum_of(const std::vector<std::uint64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

}  // namespace

void add_inks(CLI::App& command, InkOptions& options) {
    add_text(
        command, "inks", "LIST",
        [&options](const std::string& text) { options.inks = inks_of(text); },
        "Draws in colour: cmyk, or inks separated by commas: names such as black,red, or #rrggbb, "
        "or NAME=#rrggbb. Dots of all inks are even together, too; .svg has a layer an ink");
    add_number(command, "black-ink", "X", options.black_ink,
               fmt::format("With --inks: how much black replaces other inks that would look grey "
                           "together, 0 to 1 (default {})",
                           kBlackInk));
    add_text(
        command, "ink-counts", "N,N...",
        [&options](const std::string& text) { options.counts = read_counts(text); },
        "With --inks: the dots of each ink, in place of --count (default: as much as the picture "
        "needs of each)");
}

void check_inks(const InkOptions& options, const Request& request, std::optional<Mode> mode) {
    if (options.inks.empty()) {
        if (options.black_ink)
            throw BadRequest("black-ink", fmt::format("{}", *options.black_ink), "needs --inks");
        if (!options.counts.empty())
            throw BadRequest("ink-counts", fmt::format("{}", options.counts.front()),
                             "needs --inks");
        return;
    }
    if (mode && *mode != Mode::stratified)
        throw BadRequest("mode", std::string(name_of(*mode)),
                         "is not for --inks, whose dots begin stratified");
    const auto refuse = [](const char* option, const auto& value) {
        if (value)
            throw BadRequest(option, fmt::format("{}", *value),
                             "is not for --inks, whose dots begin stratified");
    };
    refuse("scale", request.scale);
    refuse("limit", request.limit);
    refuse("lines-per-radius", request.lines_per_radius);
    refuse("round-size",
           request.round_size == 0 ? std::nullopt : std::optional(request.round_size));
    if (options.counts.empty()) return;
    if (request.count)
        throw BadRequest("ink-counts", fmt::format("with --count {}", *request.count),
                         "gives the number of dots, too: must be one of both");
    if (options.counts.size() != options.inks.size())
        throw BadRequest("ink-counts", fmt::format("{} numbers", options.counts.size()),
                         fmt::format("must be one for each ink, {}", options.inks.size()));
    if (sum_of(options.counts) == 0)
        throw BadRequest("ink-counts", "0", "must not be 0 for all inks");
}

void read_tones(const Picture& picture, const InkOptions& options, drawing::Tones& tones,
                Request& request) {
    if (options.inks.empty()) {
        std::vector<Field> fields;
        fields.push_back(read_field(picture, request));
        return drawing::set_fields(tones, std::move(fields));
    }
    pictures::Colours colours = pictures::read_colours(picture.path, kLargestAspect);
    set_domain(request, colours.red.columns, colours.red.rows);
    drawing::set_fields(tones,
                        pictures::separated(std::move(colours), options.inks, picture.importance,
                                            options.black_ink.value_or(kBlackInk)),
                        options.inks);
}

void share_dots(drawing::Tones& tones, const InkOptions& options, Request& request) {
    if (!options.counts.empty()) request.count = sum_of(options.counts);
    check_request(request);
    if (options.counts.empty()) return drawing::share_dots(tones, *request.count);
    for (std::size_t k = 0; k < options.counts.size(); ++k) {
        tones.layers[k].dots = options.counts[k];
        if (options.counts[k] != 0 && pictures::is_zero_all_over(tones.fields[k].importance))
            throw BadRequest("ink-counts", fmt::format("{}", options.counts[k]),
                             fmt::format("must be 0 for {}: the picture needs none of this ink",
                                         options.inks[k].name));
    }
}

Json json_of(const InkOptions& options) {
    Json inks = Json::array();
    for (const Ink& ink : options.inks)
        inks.push_back({{"name", ink.name}, {"colour", files::hex_of(ink.colour)}});
    Json json{{"inks", inks}, {"black_ink", options.black_ink.value_or(kBlackInk)}};
    if (!options.counts.empty()) json["ink_counts"] = options.counts;
    return json;
}

std::string counts_text(const drawing::Tones& tones) {
    std::string text;
    for (const files::Layer& layer : tones.layers)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", layer.ink.name, layer.dots);
    return text;
}

}  // namespace lacuna::cli
