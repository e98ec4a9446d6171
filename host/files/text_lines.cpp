// Reads and writes lines of two numbers.
#include "files/text_lines.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

#include "base/polling.h"
#include "files/parse.h"
#include "files/point_files.h"

namespace lacuna::files {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // which some spreadsheets write first

}  // namespace

// In pixels, see base/polling.h.
constexpr std::size_t kWorkOfLine = 16;
char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// A line of text with two numbers of 17 significant digits is rarely longer.
constexpr std::size_t kUsualBytesPerLine = 48;

std::string with_room_for(std::string header, std::size_t lines) {
    header.reserve(header.size() + lines * kUsualBytesPerLine);
    return header;
}

[[noreturn]] void refuse_line(const std::string& name, std::size_t number, std::string_view line) {
    refuse(fmt::format("{}:{}", name, number),
           fmt::format("{} must be two finite numbers, such as 0.25 0.75", excerpt(line)));
}

bool read_line(std::string_view line, Point& point) {
    skip_blanks(line);
    if (take_number(line, point.x) != std::errc{}) return false;
    const std::size_t before = line.size();
    skip_blanks(line);
    if (line.size() == before || take_number(line, point.y) != std::errc{}) return false;
    skip_blanks(line);
    return line.empty() && std::isfinite(point.x) && std::isfinite(point.y);
}

bool is_skipped(std::string_view line) {
    ask_after(kWorkOfLine);
    skip_blanks(line);
    return line.empty() || line.starts_with('#');
}

std::string_view without_byte_order_mark(std::string_view bytes) {
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    return bytes;
}

}  // namespace lacuna::files
