// Reads the outlines of an SVG drawing. pugixml ignores entities that a file defines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "domains/join.h"
#include "domains/outline.h"
#include "domains/rings.h"
#include "domains/svg_path.h"
#include "domains/svg_style.h"
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
    bool is_filled = true;
    bool is_visible = true;
    bool is_chosen = true;  // whether the element lies in the layer that is read
    // An element that changes where its shapes are in a way that is not read, and its property.
    pugi::xml_node changed{};
    Property by{};
};

class Drawing {
public:
    // Only what `layer`, an id or Inkscape's label, contains is read; all if it is empty.
    Drawing(const std::string& name, pugi::xml_node root, const Page& page, Take take,
            std::string_view layer)
        : name_(name),
          page_(page),
          take_(take),
          outline_(kTolerance * std::max(page.width, page.height), take) {
        remember(root);
        if (layer.empty()) return;
        layer_ = find_layer(root, layer);
        for (pugi::xml_node node = layer_; node; node = node.parent()) around_.push_back(node);
    }

    Polygons draw(pugi::xml_node root) {
        // The y axis is reversed, because y points down on an SVG page.
        const Affine upright{1, 0, 0, -1, -page_.left, page_.top + page_.height};
        const Style style = sheets_.style_of(root);
        Inherited here = inherited(root, style, {upright, Fill::nonzero});
        here.is_chosen = layer_.empty() || layer_ == root;
        for (const Property property :
             {Property::transform, Property::translate, Property::rotate, Property::scale})
            if (!is_none(style.of(property)))
                refuse(root, fmt::format("{} {} of the whole drawing: must stand in a group",
                                         name_of(property), files::excerpt(style.of(property))));
        if (is_drawn(root, style)) draw_children(root, here, 0);
        return {take_ == Take::lines ? std::move(lines_) : join(std::move(polygons_)),
                Domain{page_.width, page_.height}};
    }

private:
    [[noreturn]] void refuse(pugi::xml_node node, const std::string& why) const {
        const std::string_view id = node.attribute("id").value();
        const std::string what =
            id.empty() ? fmt::format("byte {}: <{}>", node.offset_debug(), node.name())
                       : fmt::format("<{} id={}>", node.name(), files::excerpt(id));
        files::refuse(fmt::format("{}: {}", name_, what), why);
    }

    // Records the elements by their id, for `use`, and reads the style sheets.
    void remember(pugi::xml_node root) {
        struct Walker : pugi::xml_tree_walker {
            Drawing* drawing = nullptr;
            bool for_each(pugi::xml_node& node) override {
                const std::string_view id = node.attribute("id").value();
                if (!id.empty()) drawing->by_id_.emplace(id, node);
                if (local_name(node.name()) == "style") drawing->read_sheet(node);
                return true;
            }
        } walker;
        walker.drawing = this;
        root.traverse(walker);
    }

    // The only element with this id or, if there is none, with this label.
    pugi::xml_node find_layer(pugi::xml_node root, std::string_view layer) const {
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
            files::refuse(name_,
                          fmt::format("{} elements have the {} {}: must be one", found.size(),
                                      has_label ? "label" : "id", files::excerpt(layer)));
        std::vector<std::string>& names = walker.names[walker.names[1].empty() ? 0 : 1];
        constexpr std::size_t kShown = 8;
        const char* const more = names.size() > kShown ? ", ..." : "";
        names.resize(std::min(names.size(), kShown));
        files::refuse(name_, fmt::format("no element has the id or the label {}: there are {}{}",
                                         files::excerpt(layer), fmt::join(names, ", "), more));
    }

    // Whether an element may contain something of the layer, or lies in it.
    bool is_about_layer(pugi::xml_node node, const Inherited& outer) const {
        return outer.is_chosen || std::find(around_.begin(), around_.end(), node) != around_.end();
    }

    void read_sheet(pugi::xml_node node) {
        const std::string_view type = node.attribute("type").value();
        if (!type.empty() && type != "text/css") return;
        const std::string_view media = node.attribute("media").value();
        if (!media.empty() && media != "all" && media != "screen")
            refuse(node, fmt::format("media {}: conditions of a style sheet are not read",
                                     files::excerpt(media)));
        std::string css;
        for (const pugi::xml_node part : node.children()) css += part.value();
        sheets_.read(css, [&](const std::string& why) { refuse(node, why); });
    }

    void draw_children(pugi::xml_node parent, const Inherited& inherited, int depth) {
        for (const pugi::xml_node node : parent.children()) draw_node(node, inherited, depth);
    }

    // The value of a property whose other values are read as if it were not given.
    std::string_view one_of(pugi::xml_node node, const Style& style, Property property,
                            std::initializer_list<std::string_view> values) const {
        const std::string& value = style.of(property);
        if (value.empty() || value == "inherit" || value == "initial" || value == "unset")
            return value;
        const auto* const found = std::find(values.begin(), values.end(), value);
        if (found == values.end())
            refuse(node, fmt::format("{} {}: must be {}", name_of(property), files::excerpt(value),
                                     fmt::join(values, ", ")));
        return *found;
    }

    static bool is_none(std::string_view value) {
        return value.empty() || value == "none" || value == "initial" || value == "unset";
    }

    // Whether an element and what is in it may be drawn at all.
    bool is_drawn(pugi::xml_node node, const Style& style) const {
        if (node.attribute("requiredExtensions")) return false;
        if (node.attribute("systemLanguage"))
            refuse(node, "systemLanguage: what depends on the reader's language is not read");
        const std::string& display = style.of(Property::display);
        if (display.find('(') != std::string::npos)
            refuse(node, fmt::format("display {}: must be a word", files::excerpt(display)));
        std::string_view opacity = style.of(Property::opacity);
        double value = 1;
        const bool is_number = files::take_number(opacity, value) == std::errc{};
        return display != "none" && !(is_number && value <= 0);
    }

    // What an element hands on, with its own transform.
    Inherited inherited(pugi::xml_node node, const Style& style, const Inherited& outer) const {
        Inherited here = outer;
        const std::string_view rule =
            one_of(node, style, Property::fill_rule, {"nonzero", "evenodd"});
        if (rule == "evenodd") here.fill = Fill::even_odd;
        if (rule == "nonzero" || rule == "initial") here.fill = Fill::nonzero;
        const std::string_view visibility =
            one_of(node, style, Property::visibility, {"visible", "hidden", "collapse"});
        if (visibility == "hidden" || visibility == "collapse") here.is_visible = false;
        if (visibility == "visible" || visibility == "initial") here.is_visible = true;
        const std::string& fill = style.of(Property::fill);
        if (!fill.empty() && fill != "inherit" && fill != "unset") here.is_filled = fill != "none";
        for (const Property property :
             {Property::clip_path, Property::mask, Property::mask_image, Property::filter,
              Property::transform_origin, Property::transform_box, Property::translate,
              Property::rotate, Property::scale, Property::offset_path, Property::all})
            if (!is_none(style.of(property))) {
                here.changed = node;
                here.by = property;
            }
        return here;
    }

    void move(pugi::xml_node node, const Style& style, Affine& transform) const {
        const bool is_attribute = style.is_attribute(Property::transform);
        const std::string& value = style.of(Property::transform);
        if (is_attribute)
            check(node, read_transform(node.attribute("transform").value(), transform));
        else if (!is_none(value))
            check(node, read_css_transform(value, transform));
    }

    void draw_node(pugi::xml_node node, const Inherited& outer, int depth) {
        if (node.type() != pugi::node_element) return;
        const std::string_view kind = local_name(node.name());
        const bool is_group = kind == "g" || kind == "a" || kind == "switch";
        const bool is_nested = kind == "svg" || (kind == "symbol" && depth_of_use_ > 0);
        if (!is_group && !is_nested && kind != "use" && kind != "line" && !is_shape(kind)) return;
        if (!is_about_layer(node, outer)) return;
        const Style style = sheets_.style_of(node);
        if (!is_drawn(node, style)) return;
        if (depth > kDeepest)
            refuse(node, fmt::format("more than {} elements within each other, or a use of itself",
                                     kDeepest));
        if (++elements_ > kMostElements)
            refuse(node, fmt::format("more than {} elements, with those in use", kMostElements));
        ask_after(16);
        if (is_nested)
            refuse(node,
                   "is not read within another drawing: its outlines must stand in the outer "
                   "one, or in a group");
        Inherited here = inherited(node, style, outer);
        if (node == layer_) here.is_chosen = true;
        move(node, style, here.transform);
        if (kind == "switch") return draw_first(node, here, depth + 1);
        if (is_group) return draw_children(node, here, depth + 1);
        if (kind == "use") return draw_used(node, here, depth);
        if (here.is_visible) draw_visible(node, kind, style, here);
    }

    void draw_visible(pugi::xml_node node, std::string_view kind, const Style& style,
                      const Inherited& here) {
        if (here.changed)
            refuse(here.changed,
                   fmt::format("{} is not read, and changes where a shape is: cut or move the "
                               "shape itself",
                               name_of(here.by)));
        check_geometry(node, kind, style);
        outline_.set_transform(here.transform);
        draw_shape(node, kind);
        const bool has_open = outline_.has_open_lines();
        if (take_ == Take::insides && (kind == "line" || (has_open && !here.is_filled)))
            refuse(node,
                   "a line, which encloses nothing: it must be closed or filled, or be given to "
                   "--avoid");
        take_shape(here.fill);
        if (!outline_.is_fair())
            refuse(node,
                   "reaches too far: coordinates must be finite numbers between -1e100 and "
                   "1e100");
        if (outline_.points() > kMostPoints)
            refuse(node, fmt::format("more than {} points, with those of curves", kMostPoints));
    }

    // Of a switch, the first element whose conditions hold is drawn.
    void draw_first(pugi::xml_node parent, const Inherited& here, int depth) {
        for (const pugi::xml_node node : parent.children())
            if (node.type() == pugi::node_element && !node.attribute("requiredExtensions"))
                return draw_node(node, here, depth);
    }

    // Style sheets may give sizes, too, in place of attributes.
    void check_geometry(pugi::xml_node node, std::string_view kind, const Style& style) const {
        const auto refuse_if = [&](std::string_view of, std::initializer_list<Property> given) {
            for (const Property property : given)
                if (kind == of && !style.of(property).empty())
                    refuse(node,
                           fmt::format("{} {} of a style: must be an attribute", name_of(property),
                                       files::excerpt(style.of(property))));
        };
        refuse_if("path", {Property::d});
        refuse_if("rect", {Property::x, Property::y, Property::width, Property::height,
                           Property::rx, Property::ry});
        refuse_if("circle", {Property::cx, Property::cy, Property::r});
        refuse_if("ellipse", {Property::cx, Property::cy, Property::rx, Property::ry});
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
    pugi::xml_node layer_{};
    std::vector<pugi::xml_node> around_;  // the layer and the elements that contain it
    StyleSheets sheets_;
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

Polygons decode_svg(std::string_view bytes, const std::string& name, Take take,
                    std::string_view layer) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_pi);
    if (!parsed)
        files::refuse(name, fmt::format("byte {}: cannot be read as XML ({}); is the file whole?",
                                        parsed.offset, parsed.description()));
    for (const pugi::xml_node node : document.children())
        if (node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet")
            files::refuse(name, "<?xml-stylesheet?>: other files with styles are not read");
    const pugi::xml_node svg = document.document_element();
    if (local_name(svg.name()) != "svg")
        files::refuse(name, fmt::format("the outermost element is <{}>: must be <svg>",
                                        files::excerpt(svg.name())));
    return Drawing(name, svg, page_of(svg, name), take, layer).draw(svg);
}

}  // namespace lacuna::domains
