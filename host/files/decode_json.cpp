// Reads the format .json. Points are taken while the text is parsed, and all else after it.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/point_columns.h"
#include "files/read_points.h"
#include "options/words.h"

namespace lacuna::files {
namespace {

using Json = nlohmann::json;

constexpr int kMostDepth = 64;  // of arrays and objects in each other

// Takes points from the parser as they come, whose numbers would take far more memory as JSON. They
// are an array of pairs, alone or as "points" of an object.
class PointsOfJson {
public:
    explicit PointsOfJson(const std::string& name) : name_(name) {}

    // The parser's callback. Returns false for what shall not be kept.
    bool take(int depth, Json::parse_event_t event, Json& parsed) {
        using Event = Json::parse_event_t;
        if (depth > kMostDepth)
            refuse(name_, fmt::format("point {}: an array or an object is {} deep: must be at most "
                                      "{}",
                                      points_.size(), depth, kMostDepth));
        if (depth == 0 && event == Event::object_start) point_depth_ = 2;
        if (depth == 1 && event == Event::key) key_ = parsed.get_ref<const std::string&>();
        const bool is_root_object = depth == 0 && point_depth_ == 2;
        if (is_root_object || event == Event::key || (point_depth_ == 2 && key_ != "points"))
            return true;
        if (event == Event::object_start) refuse_point("an object");
        if (event == Event::array_start && depth > point_depth_) refuse_point("an array");
        if (event == Event::value && (depth <= point_depth_ || !parsed.is_number()))
            refuse_point(parsed.is_string() ? excerpt(parsed.get_ref<const std::string&>())
                                            : excerpt(parsed.dump()));
        if (event == Event::array_start && depth == point_depth_ - 1) {
            if (has_points_) refuse(name_, R"("points" is there twice)");
            has_points_ = true;
        }
        if (event != Event::array_end || depth != point_depth_) return true;
        add(parsed);
        return false;
    }

    PointsOfFile points() {
        if (!has_points_) refuse(name_, R"(there is no "points", an array of [x, y])");
        return {.points = std::move(points_), .z = std::move(z_)};
    }

private:
    [[noreturn]] void refuse_point(const std::string& what) const {
        refuse(name_,
               fmt::format("point {}: {} must be [x, y], two numbers", points_.size(), what));
    }

    void add(const Json& numbers) {
        if (points_.empty()) numbers_of_each_ = numbers.size() == 3 ? 3 : 2;
        if (numbers.size() != numbers_of_each_)
            refuse(name_, fmt::format("point {} has {} number{}: must be [x, y]{}", points_.size(),
                                      numbers.size(), numbers.size() == 1 ? "" : "s",
                                      numbers_of_each_ == 3 ? " and z, as point 0" : ""));
        const Point point{numbers[0].get<double>(), numbers[1].get<double>()};
        check_finite(point, points_.size(), name_);
        if (numbers_of_each_ == 3) z_.push_back(numbers[2].get<double>());
        points_.push_back(point);
    }

    const std::string& name_;
    std::vector<Point> points_;
    std::vector<double> z_;
    std::string key_;                  // the current key of the outermost object
    std::size_t numbers_of_each_ = 2;  // how many each point has
    int point_depth_ = 1;
    bool has_points_ = false;
};

// The value of a key; null if there is none.
const Json& member_of(const Json& object, const char* key) {
    static const Json null;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return !object.is_object() || found == object.end() ? null : *found;
}

// Calls `visit` with each value in arrays and objects, and with the key of the innermost object.
template <class Visit>
void for_each_value(const Json& json, const std::string& key, const Visit& visit) {
    if (!json.is_structured()) return visit(json, key);
    for (const auto& [own, value] : json.items())
        for_each_value(value, json.is_object() ? own : key, visit);
}

std::vector<double> numbers_of(const Json& json) {
    std::vector<double> numbers;
    for_each_value(json, "", [&](const Json& value, const std::string&) {
        if (value.is_number()) numbers.push_back(value.get<double>());
    });
    return numbers;
}

// A number over 0; unset if it is 0 or missing.
std::optional<double> size_of(const Json& header, const char* key, const std::string& name) {
    const Json& value = member_of(header, key);
    if (!value.is_number()) return std::nullopt;
    const auto number = value.get<double>();
    if (number < 0)
        refuse(name,
               fmt::format("\"{}\" is {}: must be a finite number of at least 0", key, number));
    return number > 0 ? std::optional(number) : std::nullopt;
}

// 0 if there is none.
double number_of(const Json& object, const char* key) {
    const Json& value = member_of(object, key);
    return value.is_number() ? value.get<double>() : 0;
}

std::optional<Boundary> boundary_of(const Json& header, const std::string& name) {
    const Json& value = member_of(header, "boundary");
    if (!value.is_string()) return std::nullopt;
    const auto word = value.get<std::string>();
    if (word != "torus" && word != "box")
        refuse(name, fmt::format(R"("boundary" is {}: must be "torus" or "box")", excerpt(word)));
    return word == "torus" ? Boundary::torus : Boundary::box;
}

// Values as texts; those of an array with colons between them.
std::map<std::string, std::string> values_of(const Json& options) {
    std::map<std::string, std::string> texts;
    for_each_value(options, "", [&](const Json& value, const std::string& key) {
        std::string text;
        if (value.is_number()) text = fmt::format("{}", value.get<double>());
        if (value.is_string()) text = value.get<std::string>();
        if (value.is_boolean() && value.get<bool>()) text = "true";
        if (text.empty() && !value.is_string()) return;
        std::string& option = texts[key];
        option += (option.empty() ? "" : ":") + text;
    });
    return texts;
}

std::vector<Level> levels_of(const Json& header, std::size_t points, const std::string& name) {
    std::vector<Level> levels;
    for (const Json& one : member_of(header, "levels")) {
        const Json& count = member_of(one, "count");
        if (!count.is_number()) continue;
        const double size = number_of(one, one.contains("scale") ? "scale" : "radius");
        const auto number = count.get<double>();
        if (!(size > 0 && std::isfinite(size)) ||
            !(number >= 0 && number <= static_cast<double>(points)))
            refuse(name, fmt::format("a level of {} points with radius {}: must be of at most {} "
                                     "points, and the radius a number over 0",
                                     number, size, points));
        levels.push_back({size, static_cast<std::uint64_t>(number)});
    }
    return levels;
}

Origin origin_of(const Json& header, std::size_t points, const std::string& name) {
    Origin origin;
    origin.scale = size_of(header, "scale", name).value_or(0);
    if (const Json& mode = member_of(header, "mode"); mode.is_string())
        origin.mode = options::named<Mode>(mode.get_ref<const std::string&>());
    if (const Json& maximal = member_of(header, "maximal"); maximal.is_boolean())
        origin.maximal = maximal.get<bool>();
    origin.values = values_of(member_of(header, "options"));
    origin.levels = levels_of(header, points, name);
    return origin;
}

LayersOfFile layers_of(const Json& layers) {
    LayersOfFile found;
    for (const Json& one : layers) {
        if (const Json& name = member_of(one, "name"); name.is_string())
            found.names.push_back(name.get<std::string>());
        if (const Json& colour = member_of(one, "colour"); colour.is_string())
            found.colours.push_back(colour.get<std::string>());
    }
    return found;
}

// Of each class; null where it has as many points as have room.
std::vector<std::optional<std::uint64_t>> counts_of(const Json& options, const std::string& name) {
    std::vector<std::optional<std::uint64_t>> counts;
    for (const Json& one : member_of(options, "counts")) {
        if (one.is_null()) counts.emplace_back();
        if (!one.is_number()) continue;
        const auto count = one.get<double>();
        if (!(count >= 1 && count < 0x1p53 && count == std::floor(count)))
            refuse(name, fmt::format("\"counts\" has {}: must be a number of points", count));
        counts.emplace_back(static_cast<std::uint64_t>(count));
    }
    return counts;
}

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

void take_columns(const Json& header, const std::string& name, PointsOfFile& file) {
    const std::size_t points = file.points.size();
    take_layers(layers_of(member_of(header, "classes")), numbers_of(member_of(header, "class")),
                "class", "classes", name, points, file.classes);
    take_layers(layers_of(member_of(header, "inks")), numbers_of(member_of(header, "ink")), "ink",
                "inks", name, points, file.inks);
    const Json& options = member_of(header, "options");
    Classes& asked = file.origin.classes;
    asked.distances = numbers_of(member_of(options, "distances"));
    asked.weights = numbers_of(member_of(options, "weights"));
    asked.counts = counts_of(options, name);
    std::vector<double>& borders = file.origin.borders;
    borders = numbers_of(member_of(options, "borders"));
    if (!asked.distances.empty()) asked.names = file.classes.names;
    const std::size_t classes = file.classes.names.size();
    for (const auto& [key, size] :
         {std::pair{"weights", asked.weights.size()}, std::pair{"counts", asked.counts.size()},
          std::pair{"borders", borders.size()}})
        if (size != 0 && size != classes)
            refuse(name, fmt::format("\"{}\" has {} values: must be {}, one for each class", key,
                                     size, classes));
    const std::vector<double> numbers = numbers_of(member_of(header, "ellipses"));
    if (!numbers.empty() && numbers.size() != 3 * points)
        refuse(name,
               fmt::format("{} points, but \"ellipses\" has {} numbers: must be [a, b, angle] "
                           "for each",
                           points, numbers.size()));
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        file.ellipses.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    file.radii = numbers_of(member_of(header, "radii"));
    if (!file.radii.empty() && file.radii.size() != points)
        refuse(name, fmt::format("{} points, but \"radii\" has {}", points, file.radii.size()));
    if (header.contains("dots")) file.other_columns = {"radius", "x_mm", "y_mm", "radius_mm"};
}

}  // namespace

PointsOfFile decode_json(std::string_view bytes, const std::string& name) {
    PointsOfJson points(name);
    Json header;
    try {
        header = Json::parse(bytes, [&](int depth, Json::parse_event_t event, Json& parsed) {
            return points.take(depth, event, parsed);
        });
    } catch (const Json::parse_error& error) {
        refuse(name,
               fmt::format("byte {}: cannot be read as JSON; is the file whole?", error.byte));
    } catch (const Json::out_of_range&) {
        refuse(name, "has a number that is too large for a double");
    }
    PointsOfFile file = points.points();
    const std::size_t count = file.points.size();
    if (const Json& said = member_of(header, "count");
        said.is_number_unsigned() && said.get<std::uint64_t>() != count)
        refuse(name, fmt::format("{} points: \"count\" says {}", count, said.get<std::uint64_t>()));
    const std::optional<double> width = size_of(header, "width", name);
    const std::optional<double> height = size_of(header, "height", name);
    if (width.has_value() != height.has_value())
        refuse(name, R"("width" and "height" must be there both or neither)");
    if (width)
        file.domain = {.width = *width,
                       .height = *height,
                       .x0 = number_of(header, "x0"),
                       .y0 = number_of(header, "y0")};
    file.depth = size_of(header, "depth", name);
    file.radius = size_of(header, "radius", name);
    file.boundary = boundary_of(header, name);
    file.origin = origin_of(header, count, name);
    take_columns(header, name, file);
    return file;
}

}  // namespace lacuna::files
