// The targets of the options of stipple.
#include "recipes/targets.h"

#include <algorithm>
#include <cstddef>

#include "recipes/read.h"

namespace lacuna::recipes {
namespace {

void read_inks(const std::string& text, std::vector<Ink>& inks) {
    inks = inks_of(text);
}

void read_counts(const std::string& text, std::vector<std::uint64_t>& counts) {
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        read("ink-counts", text.substr(begin, comma - begin), counts.emplace_back());
        begin = comma + 1;
    }
}

}  // namespace

Targets targets_of(StippleOptions& options) {
    Targets targets{{"mode", &options.start},
                    {"metric", &options.metric},
                    {"relax", &options.relax},
                    {"inks", take_by<read_inks>(options.inks)},
                    {"black-ink", &options.black_ink},
                    {"ink-counts", take_by<read_counts>(options.ink_counts)},
                    {"size-by-tone", &options.size_by_tone},
                    {"keep-inside", &options.keep_inside},
                    {"pen-path", &options.pen_path}};
    targets.merge(targets_of(options.request));
    targets.merge(targets_of(options.tone));
    return targets;
}

}  // namespace lacuna::recipes
