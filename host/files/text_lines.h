// What the text formats share: two numbers a line, comments and blank lines.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace lacuna::files {

// What stands between the two numbers of a line: blanks, or a comma with or without blanks.
enum class Between { blanks, comma };

// Room for as many lines behind what the file begins with.
std::string with_room_for(std::string header, std::size_t lines);

// Without the mark that some spreadsheets begin a file with.
std::string_view without_byte_order_mark(std::string_view bytes);

// Whether the line is blank or a comment.
bool is_skipped(std::string_view line);

// Reads the point of a line; false if it holds anything but two finite numbers.
bool read_line(std::string_view line, Between between, Point& point);

[[noreturn]] void refuse_line(const std::string& name, std::size_t number, std::string_view line,
                              Between between);

}  // namespace lacuna::files
