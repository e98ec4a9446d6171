// The format .txt: `x y` on each line, with 17 significant digits. PSA's files are read as well:
// their first line is the number of points.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

// The whole number that the line consists of, if it does.
std::optional<std::uint64_t> count_of(std::string_view line) {
    skip_blanks(line);
    std::uint64_t count = 0;
    if (take_number(line, count) != std::errc{}) return std::nullopt;
    skip_blanks(line);
    return line.empty() ? std::optional(count) : std::nullopt;
}

bool is_bare_separator(std::string_view line) {
    skip_blanks(line);
    if (!line.starts_with('#')) return false;
    line.remove_prefix(1);
    skip_blanks(line);
    return line.empty();
}

// Looks for a line that ends a set in files of UTK, the Uni(corn|form) tool kit: a .txt file can
// hold only one set.
class Separator {
public:
    void see(std::string_view line, std::size_t number, bool has_points) {
        if (has_points && at_ == 0 && is_bare_separator(line)) at_ = number;
    }
    void refuse_before_point(const std::string& name) const {
        if (at_ != 0)
            refuse(fmt::format("{}:{}", name, at_),
                   "a line of # alone ends a set in files of UTK, but a .txt holds one set: give a "
                   "file for each set, or take the line out if they are one");
    }

private:
    std::size_t at_ = 0;  // number of the first such line; 0: none was seen
};

}  // namespace

std::string encode_txt(const PointSet& set) {
    std::string bytes = with_room_for("", set.points.size());
    for (const Point& point : set.points) {
        ask_after(16);
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g} {:.17g}\n"), point.x,
                       point.y);
    }
    return bytes;
}

PointsOfFile decode_txt(std::string_view bytes, const std::string& name) {
    bytes = without_byte_order_mark(bytes);
    std::vector<Point> points;
    std::optional<std::uint64_t> count;
    Separator separator;
    bool is_first = true;
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = take_line(bytes);
        separator.see(line, number, !points.empty());
        if (is_skipped(line)) continue;
        if (std::exchange(is_first, false)) {
            count = count_of(line);
            if (count) continue;
        }
        Point point{};
        if (!read_line(line, point)) refuse_line(name, number, line);
        separator.refuse_before_point(name);
        points.push_back(point);
    }
    if (count && *count != points.size())
        refuse(name, fmt::format("{} point{}: the first line says {}", points.size(),
                                 points.size() == 1 ? "" : "s", *count));
    return {.points = std::move(points)};
}

}  // namespace lacuna::files
