// Follows symbolic links to their target.
#pragma once

#include <string>

namespace lacuna::files {

// The path at the end of a chain of links; no file need be there. Throws FileError for a loop.
std::string behind_links(const std::string& path);

}  // namespace lacuna::files
