// Text as XML and UTF-8 have it.
#include "drawing/xml.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lacuna::drawing {

std::string in_utf8(std::string_view text) {
    using Json = nlohmann::json;
    // The library checks UTF-8 where it writes, and what it has written it reads back.
    const std::string quoted =
        Json(std::string(text)).dump(-1, ' ', false, Json::error_handler_t::replace);
    return Json::parse(quoted).get<std::string>();
}

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
