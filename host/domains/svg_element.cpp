// Reads elements of an SVG drawing.
#include "domains/svg_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include "domains/rings.h"
#include "domains/svg_path.h"
#include "domains/svg_words.h"
#include "files/parse.h"

namespace lacuna::domains {
namespace {

constexpr std::string_view kXlink = "http://www.w3.org/1999/xlink";

}  // namespace

std::string_view local_name(const char* name) {
    const std::string_view all = name;
    const std::size_t colon = all.find(':');
    return colon == std::string_view::npos ? all : all.substr(colon + 1);
}

std::optional<std::string_view> namespace_of(pugi::xml_node node, std::string_view prefix) {
    const std::string key = prefix.empty() ? "xmlns" : fmt::format("xmlns:{}", prefix);
    for (; node; node = node.parent())
        if (const pugi::xml_attribute found = node.attribute(key.c_str())) return found.value();
    return std::nullopt;
}

std::string_view svg_name(const std::string& file, pugi::xml_node node) {
    const std::string_view whole = node.name();
    const std::string_view name = local_name(node.name());
    const std::string_view prefix =
        whole.substr(0, whole.size() - name.size() - (name.size() < whole.size() ? 1 : 0));
    const std::optional<std::string_view> space = namespace_of(node, prefix);
    if (!space && !prefix.empty())
        SvgElement(file, node)
            .refuse(
                fmt::format("no xmlns:{} says what namespace it is of", files::excerpt(prefix)));
    return !space || *space == "http://www.w3.org/2000/svg" ? name : std::string_view();
}

std::string_view link_of(pugi::xml_node node) {
    if (const pugi::xml_attribute plain = node.attribute("href")) return plain.value();
    for (const pugi::xml_attribute one : node.attributes()) {
        const std::string_view whole = one.name();
        if (!whole.ends_with(":href")) continue;
        const std::string_view prefix = whole.substr(0, whole.size() - 5);
        if (namespace_of(node, prefix).value_or(prefix == "xlink" ? kXlink : "") == kXlink)
            return one.value();
    }
    return {};
}

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

SvgPage page_of(const std::string& file, pugi::xml_node svg) {
    SvgPage page{0, 0, 0, 0};
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
        files::refuse(file, fmt::format("viewBox is {}: must be four numbers, left, top, width and "
                                        "height, the last two over 0",
                                        files::excerpt(box.value())));
    }
    const std::string_view width = svg.attribute("width").value();
    const std::string_view height = svg.attribute("height").value();
    page.width = pixels_of(width).value_or(0);
    page.height = pixels_of(height).value_or(0);
    if (page.width > 0 && page.height > 0 && is_fair({page.width, page.height})) return page;
    files::refuse(file, fmt::format("without a viewBox, width {} and height {}: there must be a "
                                    "viewBox, or both sizes over 0, in px, mm, cm, in, pt or pc",
                                    files::excerpt(width), files::excerpt(height)));
}

bool is_shape(std::string_view name) {
    constexpr std::array<std::string_view, 6> kShapes{"path", "polygon", "polyline",
                                                      "rect", "circle",  "ellipse"};
    return std::find(kShapes.begin(), kShapes.end(), name) != kShapes.end();
}

pugi::xml_node find_layer(const std::string& file, pugi::xml_node root, std::string_view layer) {
    struct Walker : pugi::xml_tree_walker {
        std::string_view layer;
        std::array<std::vector<pugi::xml_node>, 2> found;  // by id, by label
        std::array<std::vector<std::string>, 2> names;
        bool for_each(pugi::xml_node& node) override {
            for (const std::size_t kind : {0U, 1U}) {
                const std::string_view name =
                    node.attribute(kind == 0 ? "id" : "inkscape:label").value();
                if (!name.empty()) names[kind].push_back(files::excerpt(name));
                if (name == layer) found[kind].push_back(node);
            }
            return true;
        }
    } walker;
    walker.layer = layer;
    walker.for_each(root);  // which traverse() leaves out
    root.traverse(walker);
    const bool has_label = walker.found[0].empty();
    const std::vector<pugi::xml_node>& found = walker.found[has_label ? 1 : 0];
    if (found.size() == 1) return found.front();
    if (!found.empty())
        files::refuse(file, fmt::format("{} elements have the {} {}: must be one", found.size(),
                                        has_label ? "label" : "id", files::excerpt(layer)));
    std::vector<std::string>& names = walker.names[walker.names[1].empty() ? 0 : 1];
    constexpr std::size_t kShown = 8;
    const char* const more = names.size() > kShown ? ", ..." : "";
    names.resize(std::min(names.size(), kShown));
    files::refuse(file, fmt::format("no element has the id or the label {}: there are {}{}",
                                    files::excerpt(layer), fmt::join(names, ", "), more));
}

void SvgElement::refuse(const std::string& why) const {
    const std::string_view id = node_.attribute("id").value();
    const std::string what = id.empty()
                                 ? fmt::format("byte {}: <{}>", node_.offset_debug(), node_.name())
                                 : fmt::format("<{} id={}>", node_.name(), files::excerpt(id));
    files::refuse(fmt::format("{}: {}", file_, what), why);
}

void SvgElement::check_sizes(const Style& style) const {
    const std::string_view kind = local_name(node_.name());
    const auto refuse_if = [&](std::string_view of, std::initializer_list<Property> given) {
        for (const Property property : given)
            if (kind == of && !style.of(property).empty())
                refuse(fmt::format("{} {} of a style: must be an attribute", name_of(property),
                                   files::excerpt(style.of(property))));
    };
    refuse_if("path", {Property::d});
    refuse_if("rect", {Property::x, Property::y, Property::width, Property::height, Property::rx,
                       Property::ry});
    refuse_if("circle", {Property::cx, Property::cy, Property::r});
    refuse_if("ellipse", {Property::cx, Property::cy, Property::rx, Property::ry});
}

double SvgElement::number(const char* key, double otherwise) const {
    const pugi::xml_attribute attribute = node_.attribute(key);
    if (!attribute) return otherwise;
    const std::optional<double> found = pixels_of(attribute.value());
    if (!found)
        refuse(fmt::format("{} is {}: must be a number, of px, mm, cm, in, pt or pc", key,
                           files::excerpt(attribute.value())));
    return *found;
}

double SvgElement::size(const char* key, double otherwise) const {
    const double found = number(key, otherwise);
    if (found < 0) refuse(fmt::format("{} is {}: must be at least 0", key, found));
    return found;
}

void SvgElement::draw(Outline& outline) const {
    const std::string_view kind = local_name(node_.name());
    if (kind == "line") {
        outline.move_to({number("x1", 0), number("y1", 0)});
        return outline.line_to({number("x2", 0), number("y2", 0)});
    }
    if (kind == "path") return check(draw_path(node_.attribute("d").value(), outline));
    if (kind == "rect") return draw_rect(outline);
    if (kind == "circle") {
        const double radius = size("r", 0);
        return draw_ellipse(radius, radius, outline);
    }
    if (kind == "ellipse") return draw_ellipse(size("rx", 0), size("ry", 0), outline);
    check(draw_points(node_.attribute("points").value(), outline));
    if (kind == "polygon") outline.close();
}

void SvgElement::draw_ellipse(double rx, double ry, Outline& outline) const {
    const Point middle{number("cx", 0), number("cy", 0)};
    if (rx == 0 || ry == 0) return;
    outline.move_to({middle.x + rx, middle.y});
    outline.arc_to({rx, ry, 0}, false, true, {middle.x - rx, middle.y});
    outline.arc_to({rx, ry, 0}, false, true, {middle.x + rx, middle.y});
    outline.close();
}

void SvgElement::draw_rect(Outline& outline) const {
    const double x = number("x", 0);
    const double y = number("y", 0);
    const double width = size("width", 0);
    const double height = size("height", 0);
    if (width == 0 || height == 0) return;
    double rx = size("rx", size("ry", 0));
    double ry = size("ry", rx);
    rx = std::min(rx, width / 2);
    ry = std::min(ry, height / 2);
    const Ellipse corner{rx, ry, 0};
    outline.move_to({x + rx, y});
    outline.line_to({x + width - rx, y});
    outline.arc_to(corner, false, true, {x + width, y + ry});
    outline.line_to({x + width, y + height - ry});
    outline.arc_to(corner, false, true, {x + width - rx, y + height});
    outline.line_to({x + rx, y + height});
    outline.arc_to(corner, false, true, {x, y + height - ry});
    outline.line_to({x, y + ry});
    outline.arc_to(corner, false, true, {x + rx, y});
    outline.close();
}

}  // namespace lacuna::domains
