// The format .json. It is written and read as a stream, because a tree of millions of values would
// take gigabytes of memory.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
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

using Json = nlohmann::json;
constexpr auto kReplaceBadBytes = Json::error_handler_t::replace;

struct JsonHeader {
    std::optional<double> width;
    std::optional<double> height;
    std::optional<double> radius;
    std::optional<Boundary> boundary;
    std::optional<std::string> mode;
    std::optional<bool> maximal;
    bool has_scale = false;
    std::vector<Level> levels;
};

// Takes the parser's events: an array of pairs, or an object whose key "points" holds one.
class PointsHandler : public nlohmann::json_sax<Json> {
public:
    explicit PointsHandler(const std::string& name) : name_(name) {}

    std::vector<Point> take_points() {
        if (!has_points_) refuse(name_, R"(there is no "points", an array of [x, y])");
        if (count_ && *count_ != points_.size())
            refuse(name_, fmt::format("{} points: \"count\" says {}", points_.size(), *count_));
        return std::move(points_);
    }

    // What the outermost object says. A member is empty if its key is missing or its value is 0.
    const JsonHeader& header() const { return header_; }

    bool null() override { return scalar("null"); }
    bool boolean(bool value) override {
        if (depth_ == 1 && in_object_ && key_ == "maximal") header_.maximal = value;
        return scalar(value ? "true" : "false");
    }
    bool number_integer(number_integer_t value) override {
        return number(static_cast<double>(value));
    }
    bool number_unsigned(number_unsigned_t value) override {
        if (depth_ == 1 && in_object_ && key_ == "count") count_ = value;
        return number(static_cast<double>(value));
    }
    bool number_float(number_float_t value, const string_t&) override { return number(value); }
    bool string(string_t& value) override {
        if (depth_ == 1 && in_object_ && key_ == "boundary") header_.boundary = boundary_of(value);
        if (depth_ == 1 && in_object_ && key_ == "mode") header_.mode = value;
        return scalar(excerpt(value));
    }
    bool binary(binary_t&) override { return scalar("binary data"); }

    bool start_object(std::size_t) override {
        if (depth_ == 0) {
            in_object_ = true;
        } else {
            refuse_unless_skipped("an object");
        }
        ++depth_;
        return true;
    }

    bool key(string_t& key) override {
        if (depth_ == 1 && in_object_) key_ = key;
        if (depth_ == 2 || is_in_levels()) key_within_ = key;
        return true;
    }

    bool end_object() override {
        --depth_;
        return true;
    }

    bool start_array(std::size_t) override {
        ++depth_;
        if (depth_ == points_depth() && is_in_points()) {
            if (has_points_) refuse(name_, R"("points" is there twice)");
            has_points_ = true;
        } else if (is_in_points() && depth_ > points_depth() + 1) {
            refuse_unless_skipped("an array");
        }
        numbers_ = 0;
        return true;
    }

    bool end_array() override {
        if (is_in_points() && depth_ == points_depth() + 1) {
            if (numbers_ != 2)
                refuse(name_, fmt::format("point {} has {} number{}: must be [x, y]",
                                          points_.size(), numbers_, numbers_ == 1 ? "" : "s"));
            check_finite(point_, points_.size(), name_);
            points_.push_back(point_);
        }
        --depth_;
        return true;
    }

    // The parser's own message is not used: it quotes the file, which may hold any bytes.
    bool parse_error(std::size_t position, const std::string& token,
                     const Json::exception&) override {
        refuse(name_, fmt::format("byte {}: {} cannot be read as JSON; is the file whole?",
                                  position, excerpt(token)));
    }

private:
    // The nesting depth between two points. Inside a point the depth is one more.
    int points_depth() const { return in_object_ ? 2 : 1; }
    bool is_in_points() const { return !in_object_ || key_ == "points"; }

    void refuse_unless_skipped(const std::string& what) const {
        if (is_in_points())
            refuse(name_,
                   fmt::format("point {}: {} must be [x, y], two numbers", points_.size(), what));
    }

    // Within an object of the array "levels".
    bool is_in_levels() const { return in_object_ && depth_ == 3 && key_ == "levels"; }

    void read_level(double value) {
        if (key_within_ == "count")
            header_.levels.push_back({0, value >= 0 && value < 0x1p63
                                             ? static_cast<std::uint64_t>(value)
                                             : std::numeric_limits<std::uint64_t>::max()});
        if ((key_within_ == "radius" || key_within_ == "scale") && !header_.levels.empty())
            header_.levels.back().size = value;
    }

    bool scalar(const std::string& what) {
        refuse_unless_skipped(what);
        return true;
    }

    bool number(double value) {
        if (depth_ == 1 && in_object_) read_header(value);
        if (depth_ == 2 && in_object_ && key_ == "options" && key_within_ == "scale")
            header_.has_scale = true;
        if (is_in_levels()) read_level(value);
        if (!is_in_points()) return true;
        if (depth_ != points_depth() + 1) return scalar(fmt::format("{}", value));
        if (numbers_ < 2) (numbers_ == 0 ? point_.x : point_.y) = value;
        ++numbers_;
        return true;
    }

    Boundary boundary_of(const std::string& word) const {
        if (word != "torus" && word != "box")
            refuse(name_,
                   fmt::format(R"("boundary" is {}: must be "torus" or "box")", excerpt(word)));
        return word == "torus" ? Boundary::torus : Boundary::box;
    }

    void read_header(double value) {
        const auto set = [&](std::optional<double>& field) {
            if (value < 0 || !std::isfinite(value))
                refuse(name_, fmt::format("\"{}\" is {}: must be a finite number of at least 0",
                                          key_, value));
            if (value > 0) field = value;
        };
        if (key_ == "width") set(header_.width);
        if (key_ == "height") set(header_.height);
        if (key_ == "radius") set(header_.radius);
    }

    const std::string& name_;
    std::vector<Point> points_;
    JsonHeader header_;
    std::optional<std::uint64_t> count_;
    std::string key_;         // the current key of the outermost object
    std::string key_within_;  // the current key of an object inside it
    Point point_{};
    std::size_t numbers_ = 0;  // how many numbers of the current point were read
    int depth_ = 0;
    bool in_object_ = false;
    bool has_points_ = false;
};

// Appends the shortest digits that read back as `value`. Whole numbers get ".0", so that readers
// which distinguish 1 from 1.0 see a float, and -0.0 keeps its sign.
void append_json_number(std::string& bytes, double value) {
    const std::size_t begin = bytes.size();
    fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}"), value);
    if (bytes.find_first_of(".e", begin) == std::string::npos) bytes += ".0";
}

void append_origin(std::string& bytes, const Origin& origin) {
    // The command may contain a file name, and file names need not be valid UTF-8.
    const std::string command = Json(origin.command).dump(-1, ' ', false, kReplaceBadBytes);
    bytes += fmt::format(
        ",\"boundary\":\"{}\",\"mode\":\"{}\",\"seed\":{},\"maximal\":{},"
        "\"options\":{},\"program\":\"lacuna\",\"version\":\"{}\",\"command\":{}",
        origin.boundary == Boundary::torus ? "torus" : "box", name_of(origin.mode), origin.seed,
        origin.maximal, origin.options.empty() ? "{}" : origin.options, origin.version, command);
}

// For each level of a progressive order the number of its points, and the radius or scale at which
// they are maximal.
void append_levels(std::string& bytes, const Origin& origin) {
    bytes += "\"levels\":[";
    const char* separator = "";
    for (const Level& level : origin.levels) {
        bytes += fmt::format("{}{{\"count\":{},\"{}\":", separator, level.points,
                             origin.has_scale ? "scale" : "radius");
        append_json_number(bytes, level.size);
        bytes += '}';
        separator = ",";
    }
    bytes += "],\n";
}

void append_dots(std::string& bytes, const Dots& dots) {
    bytes += "\"dots\":{\"mm_per_unit\":";
    append_json_number(bytes, dots.millimetres_per_unit);
    bytes += ",\"left_mm\":";
    append_json_number(bytes, dots.left_mm);
    bytes += ",\"bottom_mm\":";
    append_json_number(bytes, dots.bottom_mm);
    bytes += ",\"radii\":[";
    const char* separator = "\n";
    for (const double radius : dots.radii) {
        bytes += separator;
        append_json_number(bytes, radius);
        separator = ",\n";
    }
    bytes += "]},\n";
}

void append_layers(std::string& bytes, const PointSet& set) {
    bytes += "\"inks\":[";
    const char* separator = "";
    for (const Layer& layer : set.layers) {
        bytes += fmt::format("{}{{\"name\":\"{}\",\"colour\":\"{}\",\"count\":{}}}", separator,
                             layer.ink.name, hex_of(layer.ink.colour), layer.dots);
        separator = ",";
    }
    bytes += "],\"ink\":[";
    separator = "";
    for (const std::uint8_t layer : layers_of_points(set)) {
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}{}"), separator, layer);
        separator = ",";
    }
    bytes += "],\n";
}

}  // namespace

std::string encode_json(const PointSet& set) {
    std::string bytes = with_room_for("{\"width\":", set.points.size());
    append_json_number(bytes, set.width);
    bytes += ",\"height\":";
    append_json_number(bytes, set.height);
    bytes += ",\"radius\":";
    append_json_number(bytes, set.radius);
    if (set.origin != nullptr) append_origin(bytes, *set.origin);
    bytes += fmt::format(",\"count\":{},", set.points.size());
    if (set.origin != nullptr && !set.origin->levels.empty()) append_levels(bytes, *set.origin);
    if (set.dots != nullptr) append_dots(bytes, *set.dots);
    if (!set.layers.empty()) append_layers(bytes, set);
    bytes += "\"points\":[";
    const char* separator = "\n[";
    for (const Point& point : set.points) {
        bytes += separator;
        append_json_number(bytes, point.x);
        bytes += ',';
        append_json_number(bytes, point.y);
        bytes += ']';
        separator = ",\n[";
    }
    return bytes + "]}\n";
}

SetsOfFile decode_json(std::string_view bytes, const std::string& name) {
    PointsHandler handler(name);
    Json::sax_parse(bytes, &handler);
    SetsOfFile file = one_set(handler.take_points());
    const JsonHeader& header = handler.header();
    if (header.width.has_value() != header.height.has_value())
        refuse(name, R"("width" and "height" must be there both or neither)");
    file.width = header.width;
    file.height = header.height;
    file.radius = header.radius;
    file.boundary = header.boundary;
    file.mode = header.mode;
    file.maximal = header.maximal;
    file.has_scale = header.has_scale;
    for (const Level& level : header.levels)
        if (!(level.size > 0 && std::isfinite(level.size)) || level.points > file.sets[0].size())
            refuse(name, fmt::format("a level of {} points with radius {}: must be of at most {} "
                                     "points, and the radius a number over 0",
                                     level.points, level.size, file.sets[0].size()));
    file.levels = header.levels;
    return file;
}

}  // namespace lacuna::files
