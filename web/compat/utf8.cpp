// Stands in for host/drawing/utf8.cpp: what JavaScript hands over is UTF-8, and a library of JSON
// would be 47 KB of the module.
#include <string>
#include <string_view>

#include "drawing/xml.h"

namespace lacuna::drawing {

std::string in_utf8(std::string_view text) {
    return std::string(text);
}

}  // namespace lacuna::drawing
