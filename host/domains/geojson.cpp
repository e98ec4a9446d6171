// Reads polygons from GeoJSON (RFC 7946).
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "domains/enclosed.h"
#include "domains/join.h"
#include "domains/rings.h"
#include "files/parse.h"
#include "files/text_lines.h"

namespace lacuna::domains {
namespace {

using Json = nlohmann::json;

// Lets the parser, which knows no polls, ask now and then: it reads the file through this iterator.
class Polled {
public:
    // NOLINTBEGIN(readability-identifier-naming): the standard's names for an iterator's types
    using difference_type = std::ptrdiff_t;
    using value_type = char;
    using pointer = const char*;
    using reference = const char&;
    using iterator_category = std::input_iterator_tag;
    // NOLINTEND(readability-identifier-naming)

    explicit Polled(const char* at) : at_(at) {}
    reference operator*() const { return *at_; }
    Polled& operator++() {
        if (++at_; ++read_ % kBetweenPolls == 0) ask();
        return *this;
    }
    Polled operator++(int) {
        const Polled before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const Polled& a, const Polled& b) { return a.at_ == b.at_; }

private:
    const char* at_;
    std::size_t read_ = 0;
};

// The deepest nesting of collections that is read. Ordinary files need two or three.
constexpr int kDeepestCollections = 64;

class Reader {
public:
    Reader(const std::string& name, Take take) : name_(name), take_(take) {}

    // What messages name instead of the file.
    void is_at(const std::string& place) { name_ = place; }

    void read(const Json& object, const std::string& place, int depth = 0) {
        if (depth > kDeepestCollections)
            refuse(place, "collections within each other more than 64 deep");
        const std::string type = type_of(object, place);
        if (type == "FeatureCollection") {
            read_all(member(object, "features", place), place + "features", depth);
        } else if (type == "GeometryCollection") {
            read_all(member(object, "geometries", place), place + "geometries", depth);
        } else if (type == "Feature") {
            const Json& geometry = member(object, "geometry", place);
            if (!geometry.is_null()) read(geometry, place + "geometry.", depth + 1);
        } else if (type == "Polygon") {
            read_polygon(member(object, "coordinates", place), place + "coordinates");
        } else if (type == "MultiPolygon") {
            const Json& all = array(member(object, "coordinates", place), place + "coordinates");
            for (std::size_t i = 0; i < all.size(); ++i)
                read_polygon(all[i], fmt::format("{}coordinates[{}]", place, i));
        } else if (take_ == Take::lines && (type == "Point" || type == "LineString")) {
            read_line(object, type == "Point", place);
        } else if (take_ == Take::lines && (type == "MultiPoint" || type == "MultiLineString")) {
            const std::string inner = place + "coordinates";
            const Json& all = array(member(object, "coordinates", place), inner);
            for (std::size_t i = 0; i < all.size(); ++i)
                add_line(type == "MultiPoint" ? Json::array({all[i]}) : all[i],
                         fmt::format("{}[{}]", inner, i));
        } else if (type == "LineString" || type == "MultiLineString") {
            refuse(place + "type",
                   fmt::format("{}: a line encloses nothing: must be a polygon, or be given to "
                               "--avoid",
                               type));
        } else if (type != "Point" && type != "MultiPoint") {
            refuse(place + "type", fmt::format("{}: must be a type of GeoJSON, such as Polygon",
                                               files::excerpt(type)));
        }
    }

    Polygons finish() {
        return {take_ == Take::lines ? std::move(lines_) : join(std::move(polygons_))};
    }

private:
    [[noreturn]] void refuse(const std::string& place, const std::string& why) const {
        const std::string inner = place.ends_with('.') ? place.substr(0, place.size() - 1) : place;
        files::refuse(inner.empty() ? name_ : fmt::format("{}: {}", name_, inner), why);
    }

    // A value as it is written in the file, for messages.
    static std::string text_of(const Json& value) {
        if (value.is_array()) return fmt::format("an array of {}", value.size());
        if (value.is_object()) return "an object";
        return files::excerpt(value.dump(-1, ' ', false, Json::error_handler_t::replace));
    }

    std::string type_of(const Json& object, const std::string& place) const {
        if (!object.is_object()) refuse(place, text_of(object) + ": must be an object of GeoJSON");
        const Json& type = member(object, "type", place);
        if (!type.is_string())
            refuse(place + "type", text_of(type) + ": must be a word, such as Polygon");
        return type.get<std::string>();
    }

    const Json& member(const Json& object, const char* key, const std::string& place) const {
        const auto found = object.find(key);
        if (found == object.end())
            refuse(place, fmt::format("an object without {:?}: must be GeoJSON", key));
        return *found;
    }

    const Json& array(const Json& value, const std::string& place) const {
        if (!value.is_array()) refuse(place, text_of(value) + ": must be an array");
        return value;
    }

    void read_all(const Json& objects, const std::string& place, int depth) {
        array(objects, place);
        for (std::size_t i = 0; i < objects.size(); ++i)
            read(objects[i], fmt::format("{}[{}].", place, i), depth + 1);
    }

    void read_polygon(const Json& rings, const std::string& place) {
        ask_after(16);
        array(rings, place);
        Polygon polygon;
        for (std::size_t i = 0; i < rings.size(); ++i)
            polygon.rings.push_back(ring_of(rings[i], fmt::format("{}[{}]", place, i)));
        if (take_ == Take::lines)
            std::transform(polygon.rings.begin(), polygon.rings.end(), std::back_inserter(lines_),
                           around_and_back);
        else
            polygons_.push_back({shell_less_holes(std::move(polygon.rings))});
    }

    void read_line(const Json& object, bool is_point, const std::string& place) {
        const Json& coordinates = member(object, "coordinates", place);
        add_line(is_point ? Json::array({coordinates}) : coordinates, place + "coordinates");
    }

    void add_line(const Json& positions, const std::string& place) {
        array(positions, place);
        PolygonRing line;
        for (std::size_t i = 0; i < positions.size(); ++i)
            line.push_back(point_of(positions[i], place, i));
        if (!line.empty()) lines_.push_back(there_and_back(std::move(line)));
    }

    PolygonRing ring_of(const Json& positions, const std::string& place) const {
        array(positions, place);
        PolygonRing ring;
        ring.reserve(positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i)
            ring.push_back(point_of(positions[i], place, i));
        open(ring);
        if (ring.size() < 3)
            refuse(place, fmt::format("a ring of {} point{}: must be at least 3", ring.size(),
                                      ring.size() == 1 ? "" : "s"));
        return ring;
    }

    Point point_of(const Json& position, const std::string& place, std::size_t index) const {
        const auto refuse_it = [&](const std::string& what, std::string_view allowed) {
            refuse(fmt::format("{}[{}]", place, index), fmt::format("{}: {}", what, allowed));
        };
        if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
            !position[1].is_number())
            refuse_it(text_of(position), "must be [x, y], two numbers");
        const Point point{position[0].get<double>(), position[1].get<double>()};
        if (!is_fair(point)) refuse_it(fmt::format("({}, {})", point.x, point.y), kFair);
        return point;
    }

    std::string name_;
    Take take_;
    std::vector<Polygon> polygons_;
    std::vector<PolygonRing> lines_;
};

}  // namespace

namespace {

// Throws FileError that names `name`.
Json parsed(std::string_view bytes, const std::string& name) {
    try {
        return Json::parse(Polled(bytes.data()), Polled(bytes.data() + bytes.size()));
    } catch (const Json::parse_error& error) {
        // The parser's own message is not used: it quotes the file, which may hold any bytes.
        files::refuse(
            name, fmt::format("byte {}: cannot be read as JSON; is the file whole?", error.byte));
    } catch (const Json::out_of_range&) {
        files::refuse(name, "a number that no double can hold: coordinates must be finite");
    }
}

// The marks that begin the texts of a sequence in RFC 8142.
constexpr char kMark = '\x1e';

// Whether each line is a text of its own: the first is whole, and not the only one.
bool has_texts_in_lines(std::string_view bytes) {
    std::string_view first;
    while (!bytes.empty() && files::is_skipped(first)) first = files::take_line(bytes);
    const bool has_more = bytes.find_first_not_of(" \t\r\n") != std::string_view::npos;
    return has_more && first.starts_with('{') &&
           Json::accept(Polled(first.data()), Polled(first.data() + first.size()));
}

}  // namespace

// A sequence has a text on each line, or after each mark. Messages about it name the line.
Polygons decode_geojson(std::string_view bytes, const std::string& name, Take take) {
    bytes = files::without_byte_order_mark(bytes);
    Reader reader(name, take);
    const bool is_marked = bytes.find(kMark) != std::string_view::npos;
    if (!is_marked && !has_texts_in_lines(bytes)) {
        reader.read(parsed(bytes, name), "");
        return reader.finish();
    }
    const char end = is_marked ? kMark : '\n';
    for (std::size_t line = 1; !bytes.empty();) {
        const std::string_view text = bytes.substr(0, bytes.find(end));
        bytes.remove_prefix(std::min(text.size() + 1, bytes.size()));
        const std::string place = fmt::format("{}:{}", name, line);
        if (text.find_first_not_of(" \t\r\n") != std::string_view::npos) {
            reader.is_at(place);
            reader.read(parsed(text, place), "");
        }
        line += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) +
                (is_marked ? 0 : 1);
    }
    return reader.finish();
}

}  // namespace lacuna::domains
