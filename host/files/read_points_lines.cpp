// The text formats: two numbers a line.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

std::string_view without_mark(std::string_view bytes) {
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    return bytes;
}

// One whole number alone.
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

// Finds what could be the end of a set in a file that can hold but one.
class Separator {
public:
    void see(std::string_view line, std::size_t number, bool has_points) {
        if (has_points && at_ == 0 && is_bare_separator(line)) at_ = number;
    }
    void refuse_before_point(const std::string& name) const {
        if (at_ != 0)
            refuse(fmt::format("{}:{}", name, at_),
                   "a line of # alone ends a set in a .dat file and is skipped in a .txt: name the "
                   "file .dat if several sets are in it, else take the line out");
    }

private:
    std::size_t at_ = 0;  // the first such line
};

}  // namespace

std::vector<Point> decode_counted_lines(std::string_view bytes, const std::string& name) {
    bytes = without_mark(bytes);
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
        if (!read_line(line, false, point)) refuse_line(name, number, line, false);
        separator.refuse_before_point(name);
        points.push_back(point);
    }
    if (count && *count != points.size())
        refuse(name, fmt::format("{} point{}: the first line says {}", points.size(),
                                 points.size() == 1 ? "" : "s", *count));
    return points;
}

std::vector<std::vector<Point>> decode_separated_lines(std::string_view bytes,
                                                       const std::string& name) {
    bytes = without_mark(bytes);
    std::vector<std::vector<Point>> sets(1);
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = take_line(bytes);
        if (is_skipped(line)) {
            // A blank line ends nothing; neither does a # before the first point of a set.
            const bool ends_set = line.find('#') != std::string_view::npos;
            if (ends_set && !sets.back().empty()) sets.emplace_back();
            continue;
        }
        Point point{};
        if (!read_line(line, false, point)) refuse_line(name, number, line, false);
        sets.back().push_back(point);
    }
    if (sets.size() > 1 && sets.back().empty()) sets.pop_back();
    return sets;
}

std::vector<Point> decode_lines(std::string_view bytes, bool is_csv, const std::string& name) {
    bytes = without_mark(bytes);
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
