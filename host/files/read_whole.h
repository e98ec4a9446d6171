// Reads all bytes of a file: the counterpart of write_whole.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace lacuna::files {

// The largest size of a file that is read: a quarter of this machine's memory, since the values
// made from its bytes take as much memory again, or twice.
std::uint64_t most_bytes();

// Called with the first bytes of a file, before more than those are read. It throws FileError where
// they show that the rest is not worth reading.
using LookAtFirst = std::function<void(std::string_view)>;

// All bytes of the file, or of standard input for "-". Throws FileError with the system's reason,
// or if there are more than `most` bytes: a pipe or a device, such as /dev/zero, may never end.
// `look` is called for files of 64 KiB or more.
std::string read_whole(const std::string& path, std::uint64_t most = most_bytes(),
                       const LookAtFirst& look = {});

// The name of `path` in messages: the path itself, or "standard input" for "-".
std::string name_of(const std::string& path);

}  // namespace lacuna::files
