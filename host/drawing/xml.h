// Text for XML and in UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace lacuna::drawing {

// The text as UTF-8. Invalid bytes become U+FFFD, because file names may hold any bytes.
std::string in_utf8(std::string_view text);

// The same for XML: also replaces <, & and control characters.
std::string in_xml(std::string_view text);

}  // namespace lacuna::drawing
