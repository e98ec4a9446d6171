// The bytes of a file: the counterpart of write_whole.
#pragma once

#include <string>

namespace lacuna::files {

// All bytes of the file, or of standard input for "-". Throws FileError with the system's reason.
std::string read_whole(const std::string& path);

// What messages call `path`: itself, or "standard input" for "-".
std::string name_of(const std::string& path);

}  // namespace lacuna::files
