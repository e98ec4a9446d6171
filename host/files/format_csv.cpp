// The format .csv: `x,y` a line below a header.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_sets.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

// Words, neither of which is a number: `x,y` and the like.
bool is_header(std::string_view line) {
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) return false;
    const auto is_word = [](std::string_view field) {
        skip_blanks(field);
        double number = 0;
        return !field.empty() && take_number(field, number) == std::errc::invalid_argument;
    };
    return is_word(line.substr(0, comma)) && is_word(line.substr(comma + 1));
}

}  // namespace

std::string encode_csv(const PointSet& set) {
    std::string bytes = with_room_for("x,y\n", set.points.size());
    for (const Point& point : set.points)
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g},{:.17g}\n"), point.x,
                       point.y);
    return bytes;
}

SetsOfFile decode_csv(std::string_view bytes, const std::string& name) {
    bytes = without_byte_order_mark(bytes);
    std::vector<Point> points;
    bool may_be_header = true;
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = take_line(bytes);
        if (is_skipped(line)) continue;
        Point point{};
        if (read_line(line, Between::comma, point)) {
            points.push_back(point);
        } else if (!may_be_header || !is_header(line)) {
            refuse_line(name, number, line, Between::comma);
        }
        may_be_header = false;
    }
    return one_set(std::move(points));
}

}  // namespace lacuna::files
