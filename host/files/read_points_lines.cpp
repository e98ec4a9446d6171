// The text formats txt and csv: two numbers a line.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "files/read_points_formats.h"

namespace lacuna::files {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // as some spreadsheets write it

// Takes what stands between two numbers; false if it is not there.
bool take_separator(std::string_view& rest, bool is_csv) {
    const std::size_t before = rest.size();
    skip_blanks(rest);
    if (!is_csv) return rest.size() < before;
    if (!rest.starts_with(',')) return false;
    rest.remove_prefix(1);
    skip_blanks(rest);
    return true;
}

[[noreturn]] void refuse_line(const std::string& name, std::size_t number, std::string_view line,
                              bool is_csv) {
    refuse(fmt::format("{}:{}", name, number),
           fmt::format("{} must be two finite numbers, such as {}", excerpt(line),
                       is_csv ? "0.25,0.75" : "0.25 0.75"));
}

bool read_line(std::string_view line, bool is_csv, Point& point) {
    skip_blanks(line);
    if (take_number(line, point.x) != std::errc{} || !take_separator(line, is_csv) ||
        take_number(line, point.y) != std::errc{})
        return false;
    skip_blanks(line);
    return line.empty() && std::isfinite(point.x) && std::isfinite(point.y);
}

bool is_skipped(std::string_view line) {
    skip_blanks(line);
    return line.empty() || line.starts_with('#');
}

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

std::vector<Point> decode_lines(std::string_view bytes, bool is_csv, const std::string& name) {
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    std::vector<Point> points;
    bool may_be_header = is_csv;
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = take_line(bytes);
        if (is_skipped(line)) continue;
        Point point{};
        if (read_line(line, is_csv, point)) {
            points.push_back(point);
        } else if (!may_be_header || !is_header(line)) {
            refuse_line(name, number, line, is_csv);
        }
        may_be_header = false;
    }
    return points;
}

}  // namespace lacuna::files
