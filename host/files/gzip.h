// Unpacks files of gzip, such as an .svgz.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lacuna::files {

bool is_gzip(std::string_view bytes);

// The packed file. Throws FileError, in which `name` stands for the file, if the bytes are damaged
// or hold more than `most` bytes: a small file may hold a thousand times its size.
std::string unpacked_gzip(std::string_view bytes, const std::string& name, std::size_t most);

}  // namespace lacuna::files
