// Reads the format .json: as a stream, for the reason in format_json.cpp.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/point_columns.h"
#include "files/read_sets.h"

namespace lacuna::files {
namespace {

using Json = nlohmann::json;

struct JsonHeader {
    std::optional<double> width;
    std::optional<double> height;
    double x0 = 0;
    double y0 = 0;
    std::optional<double> radius;
    std::optional<Boundary> boundary;
    std::optional<std::string> mode;
    std::optional<bool> maximal;
    std::optional<double> scale;
    std::map<std::string, std::string> options;
    std::vector<Level> levels;
    LayersOfFile classes;
    LayersOfFile inks;
    std::vector<double> class_of_point;
    std::vector<double> ink_of_point;
    std::vector<double> ellipses;  // three numbers for each
    bool has_dots = false;
    std::vector<double> distances;
    std::vector<double> weights;
    std::vector<std::optional<std::uint64_t>> counts;  // of each class
    std::vector<double> borders;
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

    bool null() override {
        if (in_object_ && key_ == "options" && key_within_ == "counts")
            header_.counts.emplace_back();
        return scalar("null");
    }
    bool boolean(bool value) override {
        if (value) read_option("true");
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
        read_option(value);
        if (depth_ == 3 && in_object_)
            for (const auto& [key, layers] :
                 {std::pair{"classes", &header_.classes}, std::pair{"inks", &header_.inks}}) {
                if (key_ != key) continue;
                if (key_within_ == "name") layers->names.push_back(value);
                if (key_within_ == "colour") layers->colours.push_back(value);
            }
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
        if (depth_ == 1 && in_object_ && key_ == "dots") header_.has_dots = true;
        if (depth_ == 2 || is_in_levels() || key_ == "classes" || key_ == "inks") key_within_ = key;
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
            if (points_.empty()) numbers_of_each_ = numbers_ == 3 ? 3 : 2;
            if (numbers_ != numbers_of_each_)
                refuse(name_, fmt::format("point {} has {} number{}: must be [x, y]{}",
                                          points_.size(), numbers_, numbers_ == 1 ? "" : "s",
                                          numbers_of_each_ == 3 ? " and z, as point 0" : ""));
            check_finite(point_, points_.size(), name_);
            if (numbers_ == 3) third_.add(z_, points_.size());
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

    // A value of the object "options"; those of an array get colons between them.
    void read_option(const std::string& text) {
        if (!in_object_ || key_ != "options" || depth_ < 2) return;
        std::string& option = header_.options[key_within_];
        option += (option.empty() ? "" : ":") + text;
    }

    void read_of_classes(double value) {
        if (key_ == "class") header_.class_of_point.push_back(value);
        if (key_ == "ink") header_.ink_of_point.push_back(value);
        if (key_ == "ellipses") header_.ellipses.push_back(value);
        if (key_ == "options" && key_within_ == "distances") header_.distances.push_back(value);
        if (key_ == "options" && key_within_ == "weights") header_.weights.push_back(value);
        if (key_ == "options" && key_within_ == "counts") header_.counts.emplace_back(whole(value));
        if (key_ == "options" && key_within_ == "borders") header_.borders.push_back(value);
    }

    std::uint64_t whole(double value) const {
        if (!(value >= 1 && value < 0x1p53 && value == std::floor(value)))
            refuse(name_,
                   fmt::format("\"{}\" has {}: must be a number of points", key_within_, value));
        return static_cast<std::uint64_t>(value);
    }

    bool scalar(const std::string& what) {
        refuse_unless_skipped(what);
        return true;
    }

    bool number(double value) {
        if (depth_ == 1 && in_object_) read_header(value);
        read_option(fmt::format("{}", value));
        if (is_in_levels()) read_level(value);
        if (in_object_ && depth_ > 1) read_of_classes(value);
        if (!is_in_points()) return true;
        if (depth_ != points_depth() + 1) return scalar(fmt::format("{}", value));
        if (numbers_ < 3) (numbers_ == 0 ? point_.x : numbers_ == 1 ? point_.y : z_) = value;
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
        if (key_ == "x0") header_.x0 = value;
        if (key_ == "y0") header_.y0 = value;
        if (key_ == "width") set(header_.width);
        if (key_ == "height") set(header_.height);
        if (key_ == "radius") set(header_.radius);
        if (key_ == "scale") set(header_.scale);
    }

    const std::string& name_;
    std::vector<Point> points_;
    JsonHeader header_;
    std::optional<std::uint64_t> count_;
    std::string key_;         // the current key of the outermost object
    std::string key_within_;  // the current key of an object inside it
    Point point_{};
    double z_ = 0;
    ThirdCoordinate third_{name_};
    std::size_t numbers_ = 0;          // how many numbers of the current point were read
    std::size_t numbers_of_each_ = 2;  // how many each point has
    int depth_ = 0;
    bool in_object_ = false;
    bool has_points_ = false;
};

// `each` has the class or ink of each point, as a place among the names.
void take_layers(LayersOfFile layers, const std::vector<double>& each, const char* word,
                 const char* words, const std::string& name, std::size_t points,
                 LayersOfFile& taken) {
    for (const double place : each) {
        if (!(place >= 0 && place < static_cast<double>(layers.names.size())))
            refuse(name, fmt::format("\"{}\" has {}: must be less than {}, the number of \"{}\"",
                                     word, place, layers.names.size(), words));
        layers.of_point.push_back(static_cast<std::uint8_t>(place));
    }
    if (!layers.names.empty() && layers.of_point.size() != points)
        refuse(name,
               fmt::format("{} points, but \"{}\" has {}", points, word, layers.of_point.size()));
    taken = std::move(layers);
}

void take_columns(const JsonHeader& header, const std::string& name, SetsOfFile& file) {
    const std::size_t points = file.sets.front().size();
    take_layers(header.classes, header.class_of_point, "class", "classes", name, points,
                file.classes);
    take_layers(header.inks, header.ink_of_point, "ink", "inks", name, points, file.inks);
    const std::size_t classes = header.classes.names.size();
    for (const auto& [key, size] :
         {std::pair{"weights", header.weights.size()}, std::pair{"counts", header.counts.size()},
          std::pair{"borders", header.borders.size()}})
        if (size != 0 && size != classes)
            refuse(name, fmt::format("\"{}\" has {} values: must be {}, one for each class", key,
                                     size, classes));
    file.distances = header.distances;
    file.weights = header.weights;
    file.counts = header.counts;
    file.borders = header.borders;
    const std::vector<double>& numbers = header.ellipses;
    if (!numbers.empty() && numbers.size() != 3 * points)
        refuse(name,
               fmt::format("{} points, but \"ellipses\" has {} numbers: must be [a, b, angle] "
                           "for each",
                           points, numbers.size()));
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        file.ellipses.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    if (header.has_dots) file.other_columns = {"radius", "x_mm", "y_mm", "radius_mm"};
}

}  // namespace

SetsOfFile decode_json(std::string_view bytes, const std::string& name) {
    PointsHandler handler(name);
    Json::sax_parse(bytes, &handler);
    SetsOfFile file = one_set(handler.take_points());
    const JsonHeader& header = handler.header();
    if (header.width.has_value() != header.height.has_value())
        refuse(name, R"("width" and "height" must be there both or neither)");
    if (header.width)
        file.domain = {
            .width = *header.width, .height = *header.height, .x0 = header.x0, .y0 = header.y0};
    file.radius = header.radius;
    file.boundary = header.boundary;
    file.mode = header.mode;
    file.maximal = header.maximal;
    file.scale = header.scale;
    file.options = header.options;
    for (const Level& level : header.levels)
        if (!(level.size > 0 && std::isfinite(level.size)) || level.points > file.sets[0].size())
            refuse(name, fmt::format("a level of {} points with radius {}: must be of at most {} "
                                     "points, and the radius a number over 0",
                                     level.points, level.size, file.sets[0].size()));
    file.levels = header.levels;
    take_columns(header, name, file);
    return file;
}

}  // namespace lacuna::files
