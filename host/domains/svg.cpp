// Reads the outlines of an SVG drawing.
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
#include "domains/svg_inherited.h"
#include "domains/svg_path.h"
#include "domains/svg_style.h"
#include "domains/xml_entities.h"
#include "files/gzip.h"
#include "files/parse.h"

namespace lacuna::domains {
namespace {

constexpr int kDeepest = 200;
constexpr double kTolerance = 0x1p-20;             // in lengths of the page's longer side
constexpr std::size_t kMostElements = 10'000'000;  // an element counts each time it is used

class Drawing {
public:
    // Only what `layer`, an id or Inkscape's label, contains is read; all if it is empty.
    Drawing(const std::string& name, pugi::xml_node root, const SvgPage& page, Take take,
            std::string_view layer)
        : name_(name),
          page_(page),
          take_(take),
          outline_(kTolerance * std::max(page.width, page.height), take),
          sheets_(take == Take::strokes) {
        remember(root);
        if (layer.empty()) return;
        layer_ = find_layer(name, root, layer);
        for (pugi::xml_node node = layer_; node; node = node.parent()) around_.push_back(node);
    }

    void draw(pugi::xml_node root) {
        // The y axis is reversed, because y points down on an SVG page.
        const Affine upright{1, 0, 0, -1, -page_.left, page_.top + page_.height};
        const Style style = sheets_.style_of(root);
        const SvgElement element(name_, root);
        Inherited here = inherited(element, style, {upright, Fill::nonzero}, take_);
        here.is_chosen = layer_.empty() || layer_ == root;
        for (const Property property :
             {Property::transform, Property::translate, Property::rotate, Property::scale})
            if (!is_none(style.of(property)))
                element.refuse(fmt::format("{} {} of the whole drawing: must stand in a group",
                                           name_of(property), files::excerpt(style.of(property))));
        if (is_drawn(element, style)) draw_children(root, here, 0);
    }

    Polygons polygons() && {
        return {take_ == Take::lines ? std::move(lines_[0]) : join(std::move(polygons_)),
                Domain{page_.width, page_.height}};
    }

    std::vector<Strokes> strokes() && {
        std::vector<Strokes> all;
        for (auto& [distance, lines] : lines_)
            all.push_back({{std::move(lines), Domain{page_.width, page_.height}}, distance});
        return all;
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
                if (local_name(node.name()) == "style" && !svg_name(drawing->name_, node).empty())
                    drawing->read_sheet(node);
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
        const std::string_view kind = svg_name(name_, node);
        const bool is_group = kind == "g" || kind == "a" || kind == "switch";
        const bool is_nested = kind == "svg" || (kind == "symbol" && depth_of_use_ > 0);
        if (!is_group && !is_nested && kind != "use" && kind != "line" && !is_shape(kind)) return;
        if (!is_about_layer(node, outer)) return;
        const Style style = sheets_.style_of(node);
        const SvgElement element(name_, node);
        if (!is_drawn(element, style)) return;
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
        Inherited here = inherited(element, style, outer, take_);
        if (node == layer_) here.is_chosen = true;
        move(node, style, here.transform);
        if (kind == "switch") return draw_first(node, here, depth + 1);
        if (is_group) return draw_children(node, here, depth + 1);
        if (kind == "use") return draw_used(node, here, depth);
        if (here.is_visible) draw_visible(node, kind, style, here);
    }

    void draw_visible(pugi::xml_node node, std::string_view kind, const Style& style,
                      const Inherited& here) {
        const SvgElement element(name_, node);
        const double half = take_ == Take::strokes ? half_of_stroke(element, style, here) : 0;
        if (take_ == Take::strokes && half == 0) return;
        if (here.changed)
            refuse(here.changed,
                   fmt::format("{} is not read, and changes where a shape is: cut or move the "
                               "shape itself",
                               name_of(here.by)));
        element.check_sizes(style);
        outline_.set_transform(here.transform);
        element.draw(outline_);
        const bool has_open = outline_.has_open_lines();
        if (take_ == Take::insides && (kind == "line" || (has_open && !here.is_filled)))
            refuse(node,
                   "a line, which encloses nothing: it must be closed or filled, or be given to "
                   "--avoid");
        take_shape(here.fill, half);
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

    void take_shape(Fill fill, double half) {
        std::vector<PolygonRing> rings = outline_.take_rings();
        if (take_ != Take::insides)
            std::move(rings.begin(), rings.end(), std::back_inserter(lines_[half]));
        else if (!rings.empty())
            polygons_.push_back({std::move(rings), fill});
    }

    void draw_used(pugi::xml_node node, Inherited inherited, int depth) {
        const std::string_view link = link_of(node);
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
    std::map<double, std::vector<PolygonRing>> lines_;  // by half of the width of their strokes
    std::map<std::string_view, pugi::xml_node> by_id_;
    pugi::xml_node layer_{};
    std::vector<pugi::xml_node> around_;  // the layer and the elements that contain it
    StyleSheets sheets_;
    std::size_t elements_ = 0;
    int depth_of_use_ = 0;
};

// The drawing in a file, with its outlines.
Drawing drawn(std::string_view bytes, const std::string& name, Take take, std::string_view layer,
              pugi::xml_document& document) {
    constexpr std::size_t kMostUnpacked = 1U << 28U;
    const std::string unpacked =
        files::is_gzip(bytes) ? files::unpacked_gzip(bytes, name, kMostUnpacked) : "";
    const std::string xml = with_entities(unpacked.empty() ? bytes : unpacked, name);
    const pugi::xml_parse_result parsed =
        document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_pi);
    if (!parsed)
        files::refuse(name, fmt::format("byte {}: cannot be read as XML ({}); is the file whole?",
                                        parsed.offset, parsed.description()));
    for (const pugi::xml_node node : document.children())
        if (node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet")
            files::refuse(name, "<?xml-stylesheet?>: other files with styles are not read");
    const pugi::xml_node svg = document.document_element();
    if (svg_name(name, svg) != "svg")
        files::refuse(name,
                      fmt::format("the outermost element is <{}>{}: must be <svg>",
                                  files::excerpt(svg.name()),
                                  local_name(svg.name()) == "svg" ? " of another namespace" : ""));
    Drawing drawing(name, svg, page_of(name, svg), take, layer);
    drawing.draw(svg);
    return drawing;
}

}  // namespace

Polygons decode_svg(std::string_view bytes, const std::string& name, Take take,
                    std::string_view layer) {
    pugi::xml_document document;
    return drawn(bytes, name, take, layer, document).polygons();
}

std::vector<Strokes> decode_strokes(std::string_view bytes, const std::string& name,
                                    std::string_view layer) {
    pugi::xml_document document;
    return drawn(bytes, name, Take::strokes, layer, document).strokes();
}

}  // namespace lacuna::domains
