// NumPy's format .npy: magic, version, length of the header, header, data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::files {

inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

struct NpyHeader {
    std::string_view descr;  // type of the numbers, such as <f8; a view of the bytes that were read
    bool fortran_order = false;
    std::vector<std::uint64_t> shape;
};

// Removes magic, version, length and header (versions 1.0 to 3.0) from `bytes`, so that the data
// remains. Throws FileError, in which `name` stands for the file.
NpyHeader take_npy_header(std::string_view& bytes, const std::string& name);

// The header, version 1.0, of an array of doubles with `count` rows and `columns` columns.
std::string npy_header(std::size_t count, int columns);

// The shape as Python prints it: (3, 2) or (3,).
std::string shape_text(const std::vector<std::uint64_t>& shape);

}  // namespace lacuna::files
