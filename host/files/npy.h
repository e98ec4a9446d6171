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
    std::string_view descr;  // the type of the numbers, such as <f8; part of the bytes read
    bool fortran_order = false;
    std::vector<std::uint64_t> shape;
};

// Takes magic, version, length and header of versions 1.0 to 3.0 from `bytes`, and leaves the
// data. Throws FileError, in which `name` stands for the file.
NpyHeader take_npy_header(std::string_view& bytes, const std::string& name);

// Of so many rows of as many columns of doubles, version 1.0.
std::string npy_header(std::size_t count, int columns);

// The shape as Python prints it: (3, 2) or (3,).
std::string shape_text(const std::vector<std::uint64_t>& shape);

}  // namespace lacuna::files
