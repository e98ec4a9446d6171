// The format .dat of UTK, the Uni(corn|form) tool kit: `x y` on each line, and a line that begins
// with # ends a set. Files of this format are read, never written.
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/read_sets.h"
#include "files/text_lines.h"

namespace lacuna::files {

SetsOfFile decode_dat(std::string_view bytes, const std::string& name) {
    bytes = without_byte_order_mark(bytes);
    std::vector<std::vector<Point>> sets(1);
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = take_line(bytes);
        if (is_skipped(line)) {
            // A blank line does not end a set. A # before the first point of a set does not either.
            const bool ends_set = line.find('#') != std::string_view::npos;
            if (ends_set && !sets.back().empty()) sets.emplace_back();
            continue;
        }
        Point point{};
        if (!read_line(line, point)) refuse_line(name, number, line);
        sets.back().push_back(point);
    }
    if (sets.size() > 1 && sets.back().empty()) sets.pop_back();
    SetsOfFile file;
    file.sets = std::move(sets);
    return file;
}

}  // namespace lacuna::files
