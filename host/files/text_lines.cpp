// Reads and writes lines of two numbers.
#include "files/text_lines.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

#include "files/parse.h"

namespace lacuna::files {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // which some spreadsheets write first

// Removes the separator between two numbers from `rest`; false if there is none.
bool take_separator(std::string_view& rest, Between between) {
    const std::size_t before = rest.size();
    skip_blanks(rest);
    if (between == Between::blanks) return rest.size() < before;
    if (!rest.starts_with(',')) return false;
    rest.remove_prefix(1);
    skip_blanks(rest);
    return true;
}

}  // namespace

// A line of text with two numbers of 17 significant digits is rarely longer.
constexpr std::size_t kUsualBytesPerLine = 48;

std::string with_room_for(std::string header, std::size_t lines) {
    header.reserve(header.size() + lines * kUsualBytesPerLine);
    return header;
}

[[noreturn]] void refuse_line(const std::string& name, std::size_t number, std::string_view line,
                              Between between) {
    refuse(fmt::format("{}:{}", name, number),
           fmt::format("{} must be two finite numbers, such as {}", excerpt(line),
                       between == Between::comma ? "0.25,0.75" : "0.25 0.75"));
}

bool read_line(std::string_view line, Between between, Point& point) {
    skip_blanks(line);
    if (take_number(line, point.x) != std::errc{} || !take_separator(line, between) ||
        take_number(line, point.y) != std::errc{})
        return false;
    skip_blanks(line);
    return line.empty() && std::isfinite(point.x) && std::isfinite(point.y);
}

bool is_skipped(std::string_view line) {
    skip_blanks(line);
    return line.empty() || line.starts_with('#');
}

std::string_view without_byte_order_mark(std::string_view bytes) {
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    return bytes;
}

}  // namespace lacuna::files
