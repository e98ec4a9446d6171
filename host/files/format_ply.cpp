// The format .ply: a header that lists elements and their properties, then the elements, as text or
// binary.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_sets.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

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

constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};

std::size_t size_of(Type type) {
    return kSizes[static_cast<std::size_t>(type)];
}

bool is_float(Type type) {
    return type == Type::f32 || type == Type::f64;
}

struct Property {
    std::string_view name;
    Type type;
    std::optional<Type> length;  // of a list
};

struct Element {
    std::string_view name;
    std::uint64_t count;
    std::vector<Property> properties;
};

struct Header {
    bool is_binary = false;
    std::vector<Element> elements;
};

// What is left of a file, and for messages where that begins.
struct Rest {
    std::string_view bytes;
    std::size_t line = 0;  // number of the line taken last
    const std::string& name;

    std::string_view take_line() {
        ++line;
        return files::take_line(bytes);
    }
    [[noreturn]] void refuse_line(const std::string& why) const {
        refuse(fmt::format("{}:{}", name, line), why);
    }
};

Type type_named(std::string_view name, const Rest& rest) {
    const auto* found = std::find_if(kTypes.begin(), kTypes.end(),
                                     [&](const NamedType& type) { return type.name == name; });
    if (found == kTypes.end())
        rest.refuse_line(fmt::format("{} is not a type of PLY, such as double", excerpt(name)));
    return found->type;
}

bool read_format(std::string_view words, const Rest& rest) {
    const std::string_view format = take_word(words);
    const std::string_view version = take_word(words);
    if ((format != "ascii" && format != "binary_little_endian") || version != "1.0")
        rest.refuse_line(fmt::format("format {} {}: must be ascii 1.0 or binary_little_endian 1.0",
                                     excerpt(format), excerpt(version)));
    return format != "ascii";
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
            header.is_binary = read_format(words, rest);
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

// Which of the vertex' properties are x and y.
struct Axes {
    std::size_t x;
    std::size_t y;
};

Axes axes_of(const Element& vertex, const std::string& name) {
    const auto find = [&](std::string_view axis) {
        const auto& all = vertex.properties;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Property& p) { return p.name == axis; });
        if (found == all.end() || found->length || !is_float(found->type))
            refuse(name, fmt::format("the element vertex must have {}, a float or double", axis));
        return static_cast<std::size_t>(found - all.begin());
    };
    return {find("x"), find("y")};
}

// Reads elements one by one, each into `values`, one for each property and 0 for a list.
class ElementReader {
public:
    ElementReader(Rest& rest, const Element& element, bool is_binary)
        : rest_(rest), element_(element), is_binary_(is_binary) {}

    void read(std::uint64_t index, std::vector<double>& values) {
        if (!is_binary_) {
            if (rest_.bytes.empty()) refuse_end(index);
            line_ = rest_.take_line();
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Property& property = element_.properties[i];
            values[i] = property.length ? skip_list(property, index) : take(property.type, index);
        }
        if (!is_binary_ && !line_.empty())
            rest_.refuse_line(fmt::format("{} is more than {} has properties", excerpt(line_),
                                          excerpt(element_.name)));
    }

private:
    [[noreturn]] void refuse_end(std::uint64_t index) const {
        refuse(rest_.name, fmt::format("ends in element {} {} of {}", excerpt(element_.name), index,
                                       element_.count));
    }

    double take(Type type, std::uint64_t index) {
        return is_binary_ ? take_binary(type, index) : take_text();
    }

    double take_text() {
        const std::string_view all = line_;
        std::string_view word = take_word(line_);
        double value = 0;
        if (take_number(word, value) != std::errc{} || !word.empty())
            rest_.refuse_line(fmt::format("{} must be a number", excerpt(all)));
        return value;
    }

    double take_binary(Type type, std::uint64_t index) {
        const std::string_view bytes = rest_.bytes;
        if (bytes.size() < size_of(type)) refuse_end(index);
        rest_.bytes.remove_prefix(size_of(type));
        switch (type) {
            case Type::i8:
                return load_little_endian<std::int8_t>(bytes);
            case Type::u8:
                return load_little_endian<std::uint8_t>(bytes);
            case Type::i16:
                return load_little_endian<std::int16_t>(bytes);
            case Type::u16:
                return load_little_endian<std::uint16_t>(bytes);
            case Type::i32:
                return load_little_endian<std::int32_t>(bytes);
            case Type::u32:
                return load_little_endian<std::uint32_t>(bytes);
            case Type::f32:
                return double{load_little_endian<float>(bytes)};
            case Type::f64:
                return load_little_endian<double>(bytes);
        }
        return 0;
    }

    double skip_list(const Property& property, std::uint64_t index) {
        const double length = take(*property.length, index);
        if (!(length >= 0))
            refuse(rest_.name, fmt::format("element {} {}: a list of length {}",
                                           excerpt(element_.name), index, length));
        for (double i = 0; i < length; ++i) take(property.type, index);
        return 0;
    }

    Rest& rest_;
    const Element& element_;
    bool is_binary_;
    std::string_view line_;  // what is left of the element's line, in text
};

// Elements without properties take no bytes: there may be any number of them to skip.
void skip(Rest& rest, const Element& element, bool is_binary) {
    if (is_binary && element.properties.empty()) return;
    std::vector<double> values(element.properties.size());
    ElementReader reader(rest, element, is_binary);
    for (std::uint64_t i = 0; i < element.count; ++i) reader.read(i, values);
}

}  // namespace

std::string encode_ply(const PointSet& set) {
    std::string bytes = with_room_for(fmt::format("ply\n"
                                                  "format ascii 1.0\n"
                                                  "element vertex {}\n"
                                                  "property double x\n"
                                                  "property double y\n"
                                                  "property double z\n"
                                                  "end_header\n",
                                                  set.points.size()),
                                      set.points.size());
    for (const Point& point : set.points)
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g} {:.17g} 0\n"), point.x,
                       point.y);
    return bytes;
}

SetsOfFile decode_ply(std::string_view bytes, const std::string& name) {
    Rest rest{bytes, 0, name};
    const Header header = read_header(rest);
    for (const Element& element : header.elements) {
        if (element.name != "vertex") {
            skip(rest, element, header.is_binary);
            continue;
        }
        const Axes axes = axes_of(element, name);
        std::vector<double> values(element.properties.size());
        ElementReader reader(rest, element, header.is_binary);
        std::vector<Point> points;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            reader.read(i, values);
            points.push_back({values[axes.x], values[axes.y]});
            check_finite(points.back(), points.size() - 1, name);
        }
        return one_set(std::move(points));
    }
    refuse(name, "there is no element vertex");
}

}  // namespace lacuna::files
