// Entities that an XML file defines for itself, which pugixml does not replace.
#pragma once

#include <string>
#include <string_view>

namespace lacuna::domains {

// The text with `&name;` replaced wherever the file's DTD defines the name. `file` is named in
// messages. Throws FileError for other names, except the five of XML itself, for definitions in
// other files, and for texts that would become too long.
std::string with_entities(std::string_view xml, const std::string& file);

}  // namespace lacuna::domains
