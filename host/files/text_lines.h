// Helpers for the text formats: lines of two numbers, comments and blank lines.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace lacuna::files {

// Returns `header`, with memory reserved for the given number of lines after it.
std::string with_room_for(std::string header, std::size_t lines);

// `bytes` without the mark that some spreadsheets write at the beginning of a file.
std::string_view without_byte_order_mark(std::string_view bytes);

// Whether the line is blank or a comment.
bool is_skipped(std::string_view line);

// Reads the point of a line; false if the line is not exactly two finite numbers with blanks
// between them.
bool read_line(std::string_view line, Point& point);

[[noreturn]] void refuse_line(const std::string& name, std::size_t number, std::string_view line);

}  // namespace lacuna::files
