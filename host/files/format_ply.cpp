// The format .ply: a header lists elements and their properties; then the elements follow, as text
// or binary.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "files/ply.h"
#include "files/point_columns.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

using ply::Element;
using ply::Header;
using ply::Property;
using ply::Rest;
using ply::Type;

// The columns of a vertex. What was found must be a number, and not a list.
PointColumns columns_of(const Element& vertex, const std::string& name) {
    std::vector<std::string> names;
    for (const Property& property : vertex.properties)
        names.emplace_back(property.length ? "a list" : property.name);
    return {names, name + ": element vertex"};
}

// Reads elements one by one into `values`: one number for each property, and 0 for a list.
class ElementReader {
public:
    ElementReader(Rest& rest, const Element& element, const Header& header)
        : rest_(rest), element_(element), is_binary_(header.is_binary), order_(header.order) {}

    void read(std::uint64_t index, std::vector<double>& values) {
        ask_after(16);
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
        if (bytes.size() < ply::size_of(type)) refuse_end(index);
        rest_.bytes.remove_prefix(ply::size_of(type));
        switch (type) {
            case Type::i8:
                return load<std::int8_t>(bytes, order_);
            case Type::u8:
                return load<std::uint8_t>(bytes, order_);
            case Type::i16:
                return load<std::int16_t>(bytes, order_);
            case Type::u16:
                return load<std::uint16_t>(bytes, order_);
            case Type::i32:
                return load<std::int32_t>(bytes, order_);
            case Type::u32:
                return load<std::uint32_t>(bytes, order_);
            case Type::f32:
                return double{load<float>(bytes, order_)};
            case Type::f64:
                return load<double>(bytes, order_);
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
    std::endian order_;
    std::string_view line_;  // the part of the element's line that was not read yet, in text
};

std::uint8_t layer_numbered(double number, std::uint64_t index, const std::string& name) {
    if (!(number >= 0 && number < 255 && number == std::floor(number)))
        refuse(name, fmt::format("point {} has class or ink {}: must be a whole number under 255",
                                 index, number));
    return static_cast<std::uint8_t>(number);
}

// Elements without properties take no bytes, so a loop over them could run for ever.
void skip(Rest& rest, const Element& element, const Header& header) {
    if (header.is_binary && element.properties.empty()) return;
    std::vector<double> values(element.properties.size());
    ElementReader reader(rest, element, header);
    for (std::uint64_t i = 0; i < element.count; ++i) reader.read(i, values);
}

}  // namespace

std::string encode_ply(const PointSet& set) {
    const std::vector<Column> columns = columns_of(set);
    const std::vector<std::uint8_t> layers = layers_of_points(set);
    std::string properties;
    for (const Column& column : columns)
        properties += fmt::format("property double {}\n", column.name);
    std::string bytes =
        with_room_for(fmt::format("ply\n"
                                  "format ascii 1.0\n"
                                  "element vertex {}\n"
                                  "property double x\n"
                                  "property double y\n"
                                  "property double z\n"
                                  "{}{}end_header\n",
                                  set.points.size(), properties,
                                  layers.empty()                      ? ""
                                  : set.layers_are == LayersAre::inks ? "property uchar ink\n"
                                                                      : "property uchar class\n"),
                      set.points.size());
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        ask_after(16);
        const Point& point = set.points[i];
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g} {:.17g} 0"), point.x,
                       point.y);
        for (const Column& column : columns)
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE(" {:.9g}"), column.values[i]);
        if (!layers.empty())
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE(" {}"), layers[i]);
        bytes += '\n';
    }
    return bytes;
}

namespace {

PointsOfFile read_vertices(Rest& rest, const Element& vertex, const Header& header,
                           const std::string& name) {
    const PointColumns columns = columns_of(vertex, name);
    PointsOfFile file;
    std::vector<Point>& points = file.points;
    std::vector<double> values(vertex.properties.size());
    ElementReader reader(rest, vertex, header);
    for (std::uint64_t i = 0; i < vertex.count; ++i) {
        reader.read(i, values);
        points.push_back({values[columns.x], values[columns.y]});
        check_finite(points.back(), points.size() - 1, name);
        if (columns.z) file.z.push_back(values[*columns.z]);
        if (columns.radius) file.radii.push_back(values[*columns.radius]);
        if (columns.a)
            file.ellipses.push_back(
                {values[*columns.a], values[*columns.b], values[*columns.angle]});
        for (const auto& [column, layers] :
             {std::pair{columns.of_class, &file.classes}, std::pair{columns.ink, &file.inks}})
            if (column) layers->of_point.push_back(layer_numbered(values[*column], i, name));
    }
    file.other_columns = columns.others;
    // A .ply has no names of classes and inks: their numbers stand for them.
    for (LayersOfFile* layers : {&file.classes, &file.inks}) {
        layers->are_numbers = true;
        for (const std::uint8_t one : layers->of_point)
            while (layers->names.size() <= one)
                layers->names.push_back(std::to_string(layers->names.size()));
    }
    return file;
}

}  // namespace

PointsOfFile decode_ply(std::string_view bytes, const std::string& name) {
    Rest rest{bytes, 0, name};
    const Header header = ply::read_header(rest);
    for (const Element& element : header.elements) {
        if (element.name == "vertex") return read_vertices(rest, element, header, name);
        skip(rest, element, header);
    }
    refuse(name, "there is no element vertex");
}

}  // namespace lacuna::files
