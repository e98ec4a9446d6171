// Reads the outlines of an SVG drawing. pugixml ignores entities that a file defines.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "domains/join.h"
#include "domains/outline.h"
#include "domains/rings.h"
#include "domains/svg_path.h"
#include "domains/svg_words.h"
#include "files/parse.h"

namespace lacuna::domains {
namespace {

constexpr int kDeepest = 200;
constexpr double kTolerance = 0x1p-20;             // in lengths of the page's longer side
constexpr std::size_t kMostElements = 10'000'000;  // an element counts each time it is used

// The name without a namespace prefix.
std::string_view local_name(const char* name) {
    const std::string_view all = name;
    const std::size_t colon = all.find(':');
    return colon == std::string_view::npos ? all : all.substr(colon + 1);
}

struct Page {
    double left;
    double top;
    double width;
    double height;
};

// A length in px, which is 1/96 of an inch.
std::optional<double> pixels_of(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, double>, 7> kUnits{{{"", 1},
                                                                         {"px", 1},
                                                                         {"in", 96},
                                                                         {"cm", 96 / 2.54},
                                                                         {"mm", 96 / 25.4},
                                                                         {"pt", 96 / 72.0},
                                                                         {"pc", 16}}};
    SvgWords words(text);
    const std::optional<double> number = words.take_number();
    const std::string_view unit = words.take_word();
    if (!number || !words.at_end()) return std::nullopt;
    for (const auto& [name, factor] : kUnits)
        if (unit == name) return *number * factor;
    return std::nullopt;
}

// What an element hands on to those within it.
struct Inherited {
    Affine transform;
    Fill fill;
};

// A property, from the attribute `style` or one of its own; without blanks.
std::string property(pugi::xml_node node, const std::string& name) {
    std::string style = fmt::format(";{};", node.attribute("style").value());
    std::erase(style, ' ');
    const std::size_t at = style.rfind(";" + name + ":");
    if (at == std::string::npos) return node.attribute(name.c_str()).value();
    const std::size_t begin = at + name.size() + 2;
    return style.substr(begin, style.find(';', begin) - begin);
}

class Drawing {
public:
    Drawing(const std::string& name, pugi::xml_node root, const Page& page, Take take)
        : name_(name),
          page_(page),
          take_(take),
          outline_(kTolerance * std::max(page.width, page.height), take) {
        remember(root);
    }

    Polygons draw(pugi::xml_node root) {
        // The y axis is reversed, because y points down on an SVG page.
        const Affine upright{1, 0, 0, -1, -page_.left, page_.top + page_.height};
        draw_children(root, {upright, fill_of(root, Fill::nonzero)}, 0);
        return {take_ == Take::lines ? std::move(lines_) : join(std::move(polygons_)), page_.width,
                page_.height};
    }

private:
    [[noreturn]] void refuse(pugi::xml_node node, const std::string& why) const {
        const std::string_view id = node.attribute("id").value();
        const std::string what =
            id.empty() ? fmt::format("byte {}: <{}>", node.offset_debug(), node.name())
                       : fmt::format("<{} id={}>", node.name(), files::excerpt(id));
        files::refuse(fmt::format("{}: {}", name_, what), why);
    }

    // Records the elements by their id, for `use`.
    void remember(pugi::xml_node root) {
        struct Walker : pugi::xml_tree_walker {
            std::map<std::string_view, pugi::xml_node>* by_id = nullptr;
            bool for_each(pugi::xml_node& node) override {
                const std::string_view id = node.attribute("id").value();
                if (!id.empty()) by_id->emplace(id, node);
                return true;
            }
        } walker;
        walker.by_id = &by_id_;
        root.traverse(walker);
    }

    void draw_children(pugi::xml_node parent, const Inherited& inherited, int depth) {
        for (const pugi::xml_node node : parent.children()) draw_node(node, inherited, depth);
    }

    static Fill fill_of(pugi::xml_node node, Fill inherited) {
        const std::string rule = property(node, "fill-rule");
        if (rule == "evenodd") return Fill::even_odd;
        return rule == "nonzero" ? Fill::nonzero : inherited;
    }

    void draw_node(pugi::xml_node node, const Inherited& outer, int depth) {
        if (node.type() != pugi::node_element || property(node, "display") == "none") return;
        if (depth > kDeepest)
            refuse(node, fmt::format("more than {} elements within each other, or a use of itself",
                                     kDeepest));
        if (++elements_ > kMostElements)
            refuse(node, fmt::format("more than {} elements, with those in use", kMostElements));
        const std::string_view kind = local_name(node.name());
        const bool is_line = kind == "line" && take_ == Take::lines;
        const bool is_group = kind == "g" || kind == "a" || kind == "switch";
        if (kind == "svg" || (kind == "symbol" && depth_of_use_ > 0))
            refuse(node,
                   "is not read within another drawing: its outlines must stand in the outer "
                   "one, or in a group");
        if (!is_group && kind != "use" && !is_shape(kind) && !is_line) return;
        Inherited here{outer.transform, fill_of(node, outer.fill)};
        check(node, read_transform(node.attribute("transform").value(), here.transform));
        if (is_group) return draw_children(node, here, depth + 1);
        if (kind == "use") return draw_used(node, here, depth);
        outline_.set_transform(here.transform);
        draw_shape(node, kind);
        take_shape(here.fill);
        if (!outline_.is_fair())
            refuse(node,
                   "reaches too far: coordinates must be finite numbers between -1e100 and "
                   "1e100");
        if (outline_.points() > kMostPoints)
            refuse(node, fmt::format("more than {} points, with those of curves", kMostPoints));
    }

    void take_shape(Fill fill) {
        std::vector<PolygonRing> rings = outline_.take_rings();
        if (take_ == Take::lines)
            std::move(rings.begin(), rings.end(), std::back_inserter(lines_));
        else if (!rings.empty())
            polygons_.push_back({std::move(rings), fill});
    }

    static bool is_shape(std::string_view kind) {
        constexpr std::array<std::string_view, 6> kShapes{"path", "polygon", "polyline",
                                                          "rect", "circle",  "ellipse"};
        return std::find(kShapes.begin(), kShapes.end(), kind) != kShapes.end();
    }

    void check(pugi::xml_node node, const std::optional<std::string>& wrong) const {
        if (wrong) refuse(node, *wrong);
    }

    void draw_used(pugi::xml_node node, Inherited inherited, int depth) {
        std::string_view link = node.attribute("href").value();
        if (link.empty()) link = node.attribute("xlink:href").value();
        const auto found = link.starts_with('#') ? by_id_.find(link.substr(1)) : by_id_.end();
        if (found == by_id_.end())
            refuse(node, fmt::format("uses {}: must be # and the id of an element of this file",
                                     files::excerpt(link)));
        const Affine moved{1, 0, 0, 1, number(node, "x", 0), number(node, "y", 0)};
        inherited.transform = inherited.transform.after(moved);
        ++depth_of_use_;
        draw_node(found->second, inherited, depth + 1);
        --depth_of_use_;
    }

    // An attribute's length in user units.
    double number(pugi::xml_node node, const char* key, double otherwise) const {
        const pugi::xml_attribute attribute = node.attribute(key);
        if (!attribute) return otherwise;
        const std::optional<double> found = pixels_of(attribute.value());
        if (!found)
            refuse(node, fmt::format("{} is {}: must be a number, of px, mm, cm, in, pt or pc", key,
                                     files::excerpt(attribute.value())));
        return *found;
    }

    double size(pugi::xml_node node, const char* key, double otherwise) const {
        const double found = number(node, key, otherwise);
        if (found < 0) refuse(node, fmt::format("{} is {}: must be at least 0", key, found));
        return found;
    }

    void draw_shape(pugi::xml_node node, std::string_view kind) {
        if (kind == "line") {
            outline_.move_to({number(node, "x1", 0), number(node, "y1", 0)});
            return outline_.line_to({number(node, "x2", 0), number(node, "y2", 0)});
        }
        if (kind == "path") return check(node, draw_path(node.attribute("d").value(), outline_));
        if (kind == "rect") return draw_rect(node);
        if (kind == "circle") {
            const double radius = size(node, "r", 0);
            return draw_ellipse(node, radius, radius);
        }
        if (kind == "ellipse") return draw_ellipse(node, size(node, "rx", 0), size(node, "ry", 0));
        check(node, draw_points(node.attribute("points").value(), outline_));
        if (kind == "polygon") outline_.close();
    }

    void draw_ellipse(pugi::xml_node node, double rx, double ry) {
        const Point middle{number(node, "cx", 0), number(node, "cy", 0)};
        if (rx == 0 || ry == 0) return;
        outline_.move_to({middle.x + rx, middle.y});
        outline_.arc_to({rx, ry, 0}, false, true, {middle.x - rx, middle.y});
        outline_.arc_to({rx, ry, 0}, false, true, {middle.x + rx, middle.y});
        outline_.close();
    }

    void draw_rect(pugi::xml_node node) {
        const double x = number(node, "x", 0);
        const double y = number(node, "y", 0);
        const double width = size(node, "width", 0);
        const double height = size(node, "height", 0);
        if (width == 0 || height == 0) return;
        double rx = size(node, "rx", size(node, "ry", 0));
        double ry = size(node, "ry", rx);
        rx = std::min(rx, width / 2);
        ry = std::min(ry, height / 2);
        const Ellipse corner{rx, ry, 0};
        outline_.move_to({x + rx, y});
        outline_.line_to({x + width - rx, y});
        outline_.arc_to(corner, false, true, {x + width, y + ry});
        outline_.line_to({x + width, y + height - ry});
        outline_.arc_to(corner, false, true, {x + width - rx, y + height});
        outline_.line_to({x + rx, y + height});
        outline_.arc_to(corner, false, true, {x, y + height - ry});
        outline_.line_to({x, y + ry});
        outline_.arc_to(corner, false, true, {x + rx, y});
        outline_.close();
    }

    const std::string& name_;
    Page page_;
    Take take_;
    Outline outline_;
    std::vector<Polygon> polygons_;
    std::vector<PolygonRing> lines_;
    std::map<std::string_view, pugi::xml_node> by_id_;
    std::size_t elements_ = 0;
    int depth_of_use_ = 0;
};

Page page_of(pugi::xml_node svg, const std::string& name) {
    Page page{0, 0, 0, 0};
    if (const pugi::xml_attribute box = svg.attribute("viewBox")) {
        SvgWords words(box.value());
        for (double* number : {&page.left, &page.top, &page.width, &page.height}) {
            const std::optional<double> found = words.take_number();
            *number = found.value_or(0);
        }
        if (!words.at_end()) page.width = 0;
        if (page.width > 0 && page.height > 0 && is_fair({page.left, page.top}) &&
            is_fair({page.width, page.height}))
            return page;
        files::refuse(name, fmt::format("viewBox is {}: must be four numbers, left, top, width and "
                                        "height, the last two over 0",
                                        files::excerpt(box.value())));
    }
    const std::string_view width = svg.attribute("width").value();
    const std::string_view height = svg.attribute("height").value();
    page.width = pixels_of(width).value_or(0);
    page.height = pixels_of(height).value_or(0);
    if (page.width > 0 && page.height > 0 && is_fair({page.width, page.height})) return page;
    files::refuse(name, fmt::format("without a viewBox, width {} and height {}: there must be a "
                                    "viewBox, or both sizes over 0, in px, mm, cm, in, pt or pc",
                                    files::excerpt(width), files::excerpt(height)));
}

}  // namespace

Polygons decode_svg(std::string_view bytes, const std::string& name, Take take) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed)
        files::refuse(name, fmt::format("byte {}: cannot be read as XML ({}); is the file whole?",
                                        parsed.offset, parsed.description()));
    const pugi::xml_node svg = document.document_element();
    if (local_name(svg.name()) != "svg")
        files::refuse(name, fmt::format("the outermost element is <{}>: must be <svg>",
                                        files::excerpt(svg.name())));
    return Drawing(name, svg, page_of(svg, name), take).draw(svg);
}

}  // namespace lacuna::domains
