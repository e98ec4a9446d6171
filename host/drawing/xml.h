// Text as XML and UTF-8 have it.
#pragma once

#include <string>
#include <string_view>

namespace lacuna::drawing {

// The text with what is not UTF-8 replaced by U+FFFD, as names of files may hold any bytes.
std::string in_utf8(std::string_view text);

// The same, where XML takes it for text: <, & and control characters replaced.
std::string in_xml(std::string_view text);

}  // namespace lacuna::drawing
