// Replaces host/drawing/utf8.cpp: text from JavaScript is valid UTF-8, and the JSON library that
// checks it would add 47 KB to the module.
#include <string>
#include <string_view>

#include "drawing/xml.h"

namespace lacuna::drawing {

std::string in_utf8(std::string_view text) {
    return std::string(text);
}

}  // namespace lacuna::drawing
