// Reads the format .json: as a stream, for the reason in format_json.cpp.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/read_sets.h"

namespace lacuna::files {
namespace {

using Json = nlohmann::json;

struct JsonHeader {
    std::optional<double> width;
    std::optional<double> height;
    std::optional<double> radius;
    std::optional<Boundary> boundary;
    std::optional<std::string> mode;
    std::optional<bool> maximal;
    bool has_scale = false;
    std::vector<Level> levels;
    std::vector<std::string> class_names;
    std::vector<double> class_of_point;
    std::vector<double> distances;
    std::vector<double> weights;
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
        if (depth_ == 3 && in_object_ && key_ == "classes" && key_within_ == "name")
            header_.class_names.push_back(value);
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
        if (depth_ == 2 || is_in_levels() || key_ == "classes") key_within_ = key;
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

    void read_of_classes(double value) {
        if (key_ == "class") header_.class_of_point.push_back(value);
        if (key_ == "options" && key_within_ == "distances") header_.distances.push_back(value);
        if (key_ == "options" && key_within_ == "weights") header_.weights.push_back(value);
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
        if (in_object_ && depth_ > 1) read_of_classes(value);
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

void take_classes(const JsonHeader& header, const std::string& name, SetsOfFile& file) {
    file.class_names = header.class_names;
    file.distances = header.distances;
    file.weights = header.weights;
    for (const double place : header.class_of_point) {
        if (!(place >= 0 && place < static_cast<double>(header.class_names.size())))
            refuse(name, fmt::format("\"class\" has {}: must be less than {}, the number of "
                                     "\"classes\"",
                                     place, header.class_names.size()));
        file.class_of_point.push_back(static_cast<std::uint8_t>(place));
    }
    if (!file.class_names.empty() && file.class_of_point.size() != file.sets.front().size())
        refuse(name, fmt::format("{} points, but \"class\" has {}", file.sets.front().size(),
                                 file.class_of_point.size()));
}

}  // namespace

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
    take_classes(header, name, file);
    return file;
}

}  // namespace lacuna::files
