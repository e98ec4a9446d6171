// The bytes of a file: the counterpart of write_whole.
#pragma once

#include <cstdint>
#include <string>

namespace lacuna::files {

// What a file may have at most: a quarter of this machine's memory, since what is made of the bytes
// takes as much again, or twice.
std::uint64_t most_bytes();

// All bytes of the file, or of standard input for "-". Throws FileError with the system's reason,
// and for more than `most`: a pipe or a device, such as /dev/zero, need not end.
std::string read_whole(const std::string& path, std::uint64_t most = most_bytes());

// What messages call `path`: itself, or "standard input" for "-".
std::string name_of(const std::string& path);

}  // namespace lacuna::files
