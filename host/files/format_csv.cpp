// The format .csv: a header line, then `x,y` on each line.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_sets.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

// Whether the line is a header: two or more words, of which none is a number, such as `x,y`.
bool is_header(std::string_view line) {
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) return false;
    const auto is_word = [](std::string_view field) {
        skip_blanks(field);
        double number = 0;
        return !field.empty() && take_number(field, number) == std::errc::invalid_argument;
    };
    return is_word(line.substr(0, comma)) && is_word(line.substr(comma + 1));
}

// The line up to its second comma: the columns after x and y are dropped.
std::string_view without_other_columns(std::string_view line) {
    const std::size_t first = line.find(',');
    const std::size_t second = first == std::string_view::npos ? first : line.find(',', first + 1);
    return line.substr(0, second);
}

}  // namespace

std::string encode_csv(const PointSet& set) {
    const std::vector<Column> columns = columns_of(set);
    const std::vector<std::uint8_t> layers = layers_of_points(set);
    std::string header = "x,y";
    for (const Column& column : columns) (header += ',') += column.name;
    if (!layers.empty()) header += set.layers_are == LayersAre::inks ? ",ink" : ",class";
    std::string bytes =
        with_room_for(header + '\n', (1 + (columns.size() + 3) / 4) * set.points.size());
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Point& point = set.points[i];
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g},{:.17g}"), point.x, point.y);
        for (const Column& column : columns)
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE(",{:.9g}"), column.values[i]);
        if (!layers.empty()) (bytes += ',') += set.layers[layers[i]].ink.name;
        bytes += '\n';
    }
    return bytes;
}

namespace {

// The classes of points, from the last column of a file whose header says so.
class ClassColumn {
public:
    explicit ClassColumn(const std::string& name) : name_(name) {}

    void see_header(std::string_view header) { is_there_ = header.ends_with(",class"); }
    void read(std::string_view line, std::size_t number, SetsOfFile& file) const {
        if (!is_there_) return;
        const std::string one(line.substr(line.rfind(',') + 1));
        auto& names = file.class_names;
        const auto found = std::find(names.begin(), names.end(), one);
        const auto place = static_cast<std::size_t>(found - names.begin());
        if (found == names.end()) names.push_back(one);
        constexpr std::size_t kMostNames = 255;
        if (one.empty() || names.size() > kMostNames)
            refuse(fmt::format("{}:{}", name_, number),
                   one.empty() ? "there is no class" : "must have at most 255 classes");
        file.class_of_point.push_back(static_cast<std::uint8_t>(place));
    }

private:
    const std::string& name_;
    bool is_there_ = false;
};

}  // namespace

SetsOfFile decode_csv(std::string_view bytes, const std::string& name) {
    bytes = without_byte_order_mark(bytes);
    SetsOfFile file = one_set({});
    std::vector<Point>& points = file.sets.front();
    ClassColumn classes(name);
    bool may_be_header = true;
    bool has_other_columns = false;
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        std::string_view line = take_line(bytes);
        if (is_skipped(line)) continue;
        // Other columns are skipped only if the header begins with `x,y,` and the next name does
        // not begin with z: a third coordinate must not be lost.
        if (may_be_header && line.starts_with("x,y,") && !line.starts_with("x,y,z")) {
            has_other_columns = true;
            may_be_header = false;
            classes.see_header(line);
            continue;
        }
        const std::string_view whole = line;
        if (has_other_columns) line = without_other_columns(line);
        Point point{};
        if (read_line(line, Between::comma, point)) {
            points.push_back(point);
            classes.read(whole, number, file);
        } else if (!may_be_header || !is_header(line)) {
            refuse_line(name, number, line, Between::comma);
        }
        may_be_header = false;
    }
    return file;
}

}  // namespace lacuna::files
