// Numbers as text, whatever the locale.
#pragma once

#include <string>

namespace lacuna {

// The shortest decimal that reads back as the same double.
std::string shortest(double value);
// Writes a number with at most this many significant digits, as printf's %g does.
std::string rounded(double value, int digits);

}  // namespace lacuna
