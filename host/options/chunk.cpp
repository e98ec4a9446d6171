// Reads I,J, and makes what a chunk keeps.
#include "options/chunk.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>

#include "base/number_text.h"

namespace lacuna::options {

Targets targets_of(ChunkOptions& options) {
    return {{"chunk", &options.at}, {"chunk-size", &options.size}};
}

std::optional<Chunk> chunk_of(const ChunkOptions& options, const Request& request) {
    if (options.at.empty()) return std::nullopt;
    const std::string_view text = options.at;
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto number_in = [&](std::string_view part) {
        std::int64_t number = 0;
        const char* const end = part.data() + part.size();
        if (const auto [stop, error] = std::from_chars(part.data(), end, number);
            error != std::errc{} || stop != end)
            throw BadRequest("chunk", shown(options.at),
                             "must be I,J, two whole numbers such as 3,-2");
        return number;
    };
    const std::int64_t i = number_in(text.substr(0, comma));
    const std::int64_t j = number_in(text.substr(std::min(comma + 1, text.size())));
    return chunk(request, i, j, options.size);
}

}  // namespace lacuna::options
