// Turns text of any bytes into valid UTF-8.
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "drawing/xml.h"

namespace lacuna::drawing {

std::string in_utf8(std::string_view text) {
    using Json = nlohmann::json;
    // The JSON library replaces invalid bytes when it writes; its reader gives the text back.
    const std::string quoted =
        Json(std::string(text)).dump(-1, ' ', false, Json::error_handler_t::replace);
    return Json::parse(quoted).get<std::string>();
}

}  // namespace lacuna::drawing
