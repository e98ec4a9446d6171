// Reads the header of PLY files.
#include "files/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

namespace lacuna::files::ply {
namespace {

struct NamedType {
    std::string_view name;
    Type type;
};

constexpr std::array<NamedType, 16> kTypes{{{"char", Type::i8},
                                            {"int8", Type::i8},
                                            {"uchar", Type::u8},
                                            {"uint8", Type::u8},
                                            {"short", Type::i16},
                                            {"int16", Type::i16},
                                            {"ushort", Type::u16},
                                            {"uint16", Type::u16},
                                            {"int", Type::i32},
                                            {"int32", Type::i32},
                                            {"uint", Type::u32},
                                            {"uint32", Type::u32},
                                            {"float", Type::f32},
                                            {"float32", Type::f32},
                                            {"double", Type::f64},
                                            {"float64", Type::f64}}};

Type type_named(std::string_view name, const Rest& rest) {
    const auto* found = std::find_if(kTypes.begin(), kTypes.end(),
                                     [&](const NamedType& type) { return type.name == name; });
    if (found == kTypes.end())
        rest.refuse_line(fmt::format("{} is not a type of PLY, such as double", excerpt(name)));
    return found->type;
}

void read_format(std::string_view words, const Rest& rest, Header& header) {
    const std::string_view format = take_word(words);
    const std::string_view version = take_word(words);
    header.is_binary = format == "binary_little_endian" || format == "binary_big_endian";
    if ((format != "ascii" && !header.is_binary) || version != "1.0")
        rest.refuse_line(
            fmt::format("format {} {}: must be ascii 1.0, binary_little_endian 1.0 or "
                        "binary_big_endian 1.0",
                        excerpt(format), excerpt(version)));
    if (format == "binary_big_endian") header.order = std::endian::big;
}

Element read_element(std::string_view words, const Rest& rest) {
    Element element{take_word(words), 0, {}};
    const std::string_view all = words;
    if (take_number(words, element.count) != std::errc{} || !words.empty())
        rest.refuse_line(fmt::format("{} must be the number of elements", excerpt(all)));
    return element;
}

Property read_property(std::string_view words, const Rest& rest) {
    Property property{};
    std::string_view type = take_word(words);
    if (type == "list") {
        property.length = type_named(take_word(words), rest);
        if (is_float(*property.length)) rest.refuse_line("the length of a list must be an integer");
        type = take_word(words);
    }
    property.type = type_named(type, rest);
    property.name = take_word(words);
    return property;
}

}  // namespace

Header read_header(Rest& rest) {
    if (rest.take_line() != "ply") refuse(rest.name, "not a .ply file: its first line must be ply");
    Header header;
    bool has_format = false;
    for (;;) {
        if (rest.bytes.empty()) refuse(rest.name, "ends in its header, before end_header");
        const std::string_view line = rest.take_line();
        std::string_view words = line;
        const std::string_view keyword = take_word(words);
        if (keyword == "end_header") break;
        if (keyword == "format") {
            read_format(words, rest, header);
            has_format = true;
        } else if (keyword == "element") {
            header.elements.push_back(read_element(words, rest));
        } else if (keyword == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(read_property(words, rest));
        } else if (keyword != "comment" && keyword != "obj_info") {
            rest.refuse_line(fmt::format("{} does not belong in a PLY header", excerpt(line)));
        }
    }
    if (!has_format) refuse(rest.name, "the header has no line `format`");
    return header;
}

}  // namespace lacuna::files::ply
