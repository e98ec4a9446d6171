// The bytes of files for tests of the readers.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "files/little_endian.h"
#include "files/point_files.h"

namespace lacuna::files {

// The formats that are both written and read.
inline std::vector<Format> readable() {
    std::vector<Format> both;
    for (const Format& format : formats())
        if (format.decode != nullptr) both.push_back(format);
    return both;
}

inline std::string npy(int major, const std::string& header, const std::string& data) {
    std::string bytes = "\x93NUMPY";
    bytes += static_cast<char>(major);
    bytes += '\0';
    for (int i = 0; i < (major == 1 ? 2 : 4); ++i)
        bytes += static_cast<char>((header.size() >> (8 * i)) & 0xffU);
    return bytes + header + data;
}

inline std::string doubles(const std::vector<double>& values) {
    std::string bytes;
    for (const double value : values) append_little_endian(bytes, value);
    return bytes;
}

inline std::string floats(const std::vector<float>& values) {
    std::string bytes;
    for (const float value : values)
        for (unsigned i = 0; i < 4; ++i)
            bytes += static_cast<char>((std::bit_cast<std::uint32_t>(value) >> (8 * i)) & 0xffU);
    return bytes;
}

}  // namespace lacuna::files
