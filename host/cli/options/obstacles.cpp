// Reads obstacles.
#include "cli/options/obstacles.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/options/options.h"
#include "domains/rings.h"
#include "files/parse.h"
#include "files/read_whole.h"
#include "files/text_lines.h"

namespace lacuna::cli {
namespace {

struct FileAndWidth {
    std::string path;
    std::optional<double> width;
};

// A colon begins the width if a number follows, to the end.
FileAndWidth file_and_width(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) return {text, {}};
    std::string_view rest = std::string_view(text).substr(colon + 1);
    double width = 0;
    if (files::take_number(rest, width) != std::errc{} || !rest.empty()) return {text, {}};
    if (!(width > 0 && std::isfinite(width)))
        throw BadRequest("avoid", shown(text), "the width must be a finite number over 0");
    return {text.substr(0, colon), width};
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t comma = 0; comma != std::string_view::npos; line.remove_prefix(comma + 1)) {
        comma = line.find(',');
        std::string_view field = line.substr(0, comma);
        files::skip_blanks(field);
        while (field.ends_with(' ') || field.ends_with('\t')) field.remove_suffix(1);
        fields.push_back(field);
        if (comma == std::string_view::npos) break;
    }
    return fields;
}

// The columns x, y and radius of a .csv, by its header; without one x and y come first.
class PointColumns {
public:
    PointColumns(const std::string& name, std::optional<double> width)
        : name_(name), width_(width) {}

    // Whether the line is the header.
    bool see(const std::vector<std::string_view>& fields) {
        const auto find = [&](std::string_view key) {
            const auto found = std::find(fields.begin(), fields.end(), key);
            return found == fields.end() ? kNone : static_cast<std::size_t>(found - fields.begin());
        };
        const std::size_t x = find("x"), y = find("y");
        if (x == kNone || y == kNone) return false;
        x_ = x;
        y_ = y;
        radius_ = find("radius");
        return true;
    }

    void read(const std::vector<std::string_view>& fields, std::size_t line,
              std::map<double, std::vector<PolygonRing>>& by_radius) const {
        const std::string place = fmt::format("{}:{}", name_, line);
        const Point point{number(fields, x_, place), number(fields, y_, place)};
        if (!domains::is_fair(point))
            files::refuse(place, fmt::format("({}, {}): {}", point.x, point.y, domains::kFair));
        if (!width_ && radius_ == kNone)
            throw BadRequest("avoid", shown(name_),
                             "has no column radius: give FILE:WIDTH, the distance to keep");
        const double radius = width_ ? *width_ : number(fields, radius_, place);
        if (radius < 0) files::refuse(place, fmt::format("radius {}: must be at least 0", radius));
        if (radius > 0) by_radius[radius].push_back({point});
    }

private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    static double number(const std::vector<std::string_view>& fields, std::size_t column,
                         const std::string& place) {
        double value = 0;
        std::string_view field = column < fields.size() ? fields[column] : std::string_view();
        const std::string_view whole = field;
        if (files::take_number(field, value) != std::errc{} || !field.empty() ||
            !std::isfinite(value))
            files::refuse(place, fmt::format("column {} is {}: must be a number", column + 1,
                                             files::excerpt(whole)));
        return value;
    }

    const std::string& name_;
    std::optional<double> width_;
    std::size_t x_ = 0;
    std::size_t y_ = 1;
    std::size_t radius_ = kNone;
};

std::vector<Obstacles> read_disks(const FileAndWidth& given) {
    const std::string bytes = files::read_whole(given.path);
    const std::string name = files::name_of(given.path);
    std::string_view rest = files::without_byte_order_mark(bytes);
    PointColumns columns(name, given.width);
    std::map<double, std::vector<PolygonRing>> by_radius;
    bool may_be_header = true;
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::string_view line = files::take_line(rest);
        if (files::is_skipped(line)) continue;
        const std::vector<std::string_view> fields = fields_of(line);
        if (!std::exchange(may_be_header, false) || !columns.see(fields))
            columns.read(fields, number, by_radius);
    }
    std::vector<Obstacles> all;
    all.reserve(by_radius.size());
    for (auto& [radius, rings] : by_radius) all.push_back({{std::move(rings), 0, 0}, radius});
    return all;
}

}  // namespace

std::string path_of_obstacles(const std::string& text) {
    return file_and_width(text).path;
}

std::vector<Obstacles> read_obstacles(const std::string& text) {
    const FileAndWidth given = file_and_width(text);
    if (given.path.ends_with(".csv")) return read_disks(given);
    Polygons lines = read_lines(given.path);
    if (!given.width)
        throw BadRequest("avoid", shown(text),
                         "needs a width, as in FILE:2.5: how far points stay from its lines");
    return {{std::move(lines), *given.width}};
}

}  // namespace lacuna::cli
