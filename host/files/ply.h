// The header of PLY files: elements and their properties.
#pragma once

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/parse.h"

namespace lacuna::files::ply {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

inline bool is_float(Type type) {
    return type == Type::f32 || type == Type::f64;
}

inline constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};

inline std::size_t size_of(Type type) {
    return kSizes[static_cast<std::size_t>(type)];
}

struct Property {
    std::string_view name;
    Type type;
    std::optional<Type> length;  // the type of a list's length; empty if the property is no list
};

struct Element {
    std::string_view name;
    std::uint64_t count;
    std::vector<Property> properties;
};

struct Header {
    bool is_binary = false;
    std::endian order = std::endian::little;  // of the bytes of numbers, if it is binary
    std::vector<Element> elements;
};

// The part of a file that was not read yet, and where it begins, for messages.
struct Rest {
    std::string_view bytes;
    std::size_t line = 0;  // number of the line that was taken last
    const std::string& name;

    std::string_view take_line() {
        ++line;
        return files::take_line(bytes);
    }
    [[noreturn]] void refuse_line(const std::string& why) const {
        refuse(fmt::format("{}:{}", name, line), why);
    }
};

// Removes the header, up to end_header, from `rest`. Throws FileError.
Header read_header(Rest& rest);

}  // namespace lacuna::files::ply
