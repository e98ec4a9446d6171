// Where links lead to.
#pragma once

#include <string>

namespace lacuna::files {

// The file that a chain of links ends at, there or not. Throws FileError for a chain without end.
std::string behind_links(const std::string& path);

}  // namespace lacuna::files
