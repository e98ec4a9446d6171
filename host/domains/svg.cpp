// Reads the outlines of an SVG drawing. pugixml ignores entities that a file defines.
#include <fmt/format.h>

#include <algorithm>
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
#include "domains/svg_element.h"
#include "domains/svg_path.h"
#include "domains/svg_style.h"
#include "files/parse.h"

namespace lacuna::domains {
namespace {

constexpr int kDeepest = 200;
constexpr double kTolerance = 0x1p-20;             // in lengths of the page's longer side
constexpr std::size_t kMostElements = 10'000'000;  // an element counts each time it is used

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
    Drawing(const std::string& name, pugi::xml_node root, const SvgPage& page, Take take,
            std::string_view layer)
        : name_(name),
          page_(page),
          take_(take),
          outline_(kTolerance * std::max(page.width, page.height), take) {
        remember(root);
        if (layer.empty()) return;
        layer_ = find_layer(name, root, layer);
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
        SvgElement(name_, node).refuse(why);
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
            SvgElement(name_, node)
                .check(read_transform(node.attribute("transform").value(), transform));
        else if (!is_none(value))
            SvgElement(name_, node).check(read_css_transform(value, transform));
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
        const SvgElement element(name_, node);
        element.check_sizes(style);
        outline_.set_transform(here.transform);
        element.draw(outline_);
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

    void take_shape(Fill fill) {
        std::vector<PolygonRing> rings = outline_.take_rings();
        if (take_ == Take::lines)
            std::move(rings.begin(), rings.end(), std::back_inserter(lines_));
        else if (!rings.empty())
            polygons_.push_back({std::move(rings), fill});
    }

    void draw_used(pugi::xml_node node, Inherited inherited, int depth) {
        std::string_view link = node.attribute("href").value();
        if (link.empty()) link = node.attribute("xlink:href").value();
        const auto found = link.starts_with('#') ? by_id_.find(link.substr(1)) : by_id_.end();
        if (found == by_id_.end())
            refuse(node, fmt::format("uses {}: must be # and the id of an element of this file",
                                     files::excerpt(link)));
        const SvgElement use(name_, node);
        const Affine moved{1, 0, 0, 1, use.number("x", 0), use.number("y", 0)};
        inherited.transform = inherited.transform.after(moved);
        ++depth_of_use_;
        draw_node(found->second, inherited, depth + 1);
        --depth_of_use_;
    }

    const std::string& name_;
    SvgPage page_;
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
    return Drawing(name, svg, page_of(name, svg), take, layer).draw(svg);
}

}  // namespace lacuna::domains
