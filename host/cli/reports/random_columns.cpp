// Reads --columns, and draws their numbers.
#include "cli/reports/random_columns.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/number_text.h"
#include "options/read.h"
#include "rounds/random.h"

namespace lacuna::cli {
namespace {

constexpr RandomColumn kAngle{"angle", 0, 360, 0xa49e};
constexpr RandomColumn kSize{"size", 0.8, 1.2, 0x512e};

RandomColumn column_of(const std::string& part, const std::string& text) {
    const auto refuse = [&](const char* why) { throw BadRequest("columns", shown(text), why); };
    if (part == kAngle.name) return kAngle;
    RandomColumn column = kSize;
    const std::size_t colon = std::min(part.find(':'), part.size());
    if (part.substr(0, colon) != kSize.name)
        refuse("must be angle, size, or size:LEAST..MOST, with commas between them");
    if (colon == part.size()) return column;
    const std::string range = part.substr(colon + 1);
    const std::size_t dots = range.find("..");
    if (dots == std::string::npos) refuse("a size must have two numbers, as in size:0.8..1.2");
    options::read("columns", range.substr(0, dots), column.least);
    options::read("columns", range.substr(dots + 2), column.most);
    if (!(column.least > 0 && column.most >= column.least && std::isfinite(column.most)))
        refuse("sizes must be finite numbers over 0, the least one first");
    return column;
}

}  // namespace

std::vector<RandomColumn> read_columns(const std::string& text,
                                       const std::vector<Output>& outputs) {
    std::vector<RandomColumn> columns;
    if (text.empty()) return columns;
    for (const std::string& part : options::parts_of_list(text)) {
        columns.push_back(column_of(part, text));
        for (std::size_t i = 0; i + 1 < columns.size(); ++i)
            if (columns[i].stream == columns.back().stream)
                throw BadRequest("columns", shown(text), "each may be given once");
    }
    const bool has_no_columns = are_pictures(outputs);
    for (const Output& output : outputs)
        if (!output.format.has_columns || output.format.name() == "npy" || has_no_columns)
            throw BadRequest("columns", shown(text),
                             "have no place in " + std::string(output.format.extension) +
                                 ": give --output FILE with one of .csv .ply .geojson .json, or "
                                 "--format");
    return columns;
}

std::vector<files::Column> values_of(const std::vector<RandomColumn>& columns, std::uint64_t seed,
                                     std::size_t points) {
    std::vector<files::Column> all;
    for (const RandomColumn& column : columns) {
        std::vector<double>& values = all.emplace_back(files::Column{column.name, {}}).values;
        values.reserve(points);
        for (std::size_t i = 0; i < points; ++i) {
            const auto bits = random_bits(seed, i, column.stream).first;
            const double share = static_cast<double>(bits >> 11U) * 0x1p-53;
            values.push_back(column.least + share * (column.most - column.least));
        }
    }
    return all;
}

}  // namespace lacuna::cli
