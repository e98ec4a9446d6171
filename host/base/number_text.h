// Numbers as text, whatever the locale, and texts for messages.
#pragma once

#include <string>

namespace lacuna {

// The shortest decimal that reads back as the same double.
std::string shortest(double value);
// Writes a number with at most this many significant digits, as printf's %g does.
std::string rounded(double value, int digits);

// A time in words, such as "50 s", "12 min" or "2 h 5 min".
std::string time_text(double seconds);

// A given text for a message: in quotes if it is empty, or has blanks or control characters.
std::string shown(const std::string& text);

}  // namespace lacuna
