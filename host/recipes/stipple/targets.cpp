// The targets of the options of stipple.
#include "recipes/targets.h"

#include <algorithm>
#include <cstddef>

#include "recipes/read.h"

namespace lacuna::recipes {
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

}  // namespace

Targets targets_of(StippleOptions& options) {
    Targets targets{
        {"mode", &options.start},
        {"metric", &options.metric},
        {"relax", &options.relax},
        {"inks", [&options](const std::string& text) { options.inks = inks_of(text); }},
        {"black-ink", &options.black_ink},
        {"ink-counts",
         [&options](const std::string& text) { options.ink_counts = read_counts(text); }},
        {"size-by-tone", &options.size_by_tone},
        {"keep-inside", &options.keep_inside},
        {"pen-path", &options.pen_path}};
    targets.merge(targets_of(options.request));
    targets.merge(targets_of(options.tone));
    return targets;
}

}  // namespace lacuna::recipes
