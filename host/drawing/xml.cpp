// Escapes text for XML.
#include "drawing/xml.h"

#include <string>
#include <string_view>

namespace lacuna::drawing {

std::string in_xml(std::string_view text) {
    std::string result;
    for (const char c : in_utf8(text)) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else if (c >= 0 && c < ' ') {
            result += "\uFFFD";
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace lacuna::drawing
