// The properties of an SVG's elements: from their attributes, from style sheets and from `style`.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace lacuna::domains {

// Which properties are read: those that hide or move shapes, or change their outline. The first
// ones may also be given as attributes.
enum class Property : std::size_t {
    display,
    visibility,
    opacity,
    fill,
    fill_rule,
    transform,
    clip_path,
    mask,
    filter,
    transform_origin,
    stroke,  // this and the next three only with the widths of strokes
    stroke_width,
    stroke_opacity,
    vector_effect,
    end_of_attributes,
    mask_image = end_of_attributes,
    transform_box,
    translate,
    rotate,
    scale,
    offset_path,
    all,
    d,
    x,
    y,
    width,
    height,
    cx,
    cy,
    r,
    rx,
    ry,
    count,
};

std::string_view name_of(Property property);

// The properties of one element. Values are in lower case, without blanks around them.
class Style {
public:
    // Empty if the property is not given.
    const std::string& of(Property property) const { return given(property).value; }
    // Whether the value is that of an attribute, which has a syntax of its own.
    bool is_attribute(Property property) const { return std::get<1>(given(property).rank) == 0; }

private:
    friend class StyleSheets;

    // Which of two values counts: an important one, then that of the attribute `style` (2) over
    // that of a rule (1) and that of an attribute (0), then the more specific and the later rule.
    using Rank = std::tuple<bool, int, int, std::size_t>;
    struct Declaration {
        std::string value;
        Rank rank{};
    };
    const Declaration& given(Property property) const {
        return given_[static_cast<std::size_t>(property)];
    }
    void give(Property property, std::string_view value, const Rank& rank);

    std::array<Declaration, static_cast<std::size_t>(Property::count)> given_;
};

class StyleSheets {
public:
    // Called with what cannot be read; does not return.
    using Refuse = std::function<void(const std::string& why)>;

    // Without strokes their properties are skipped, and so are rules that set nothing else.
    explicit StyleSheets(bool with_strokes) : with_strokes_(with_strokes) {}

    // Reads the rules of a <style>. Selectors of an element, of classes and of an id are read.
    // Refuses others, and conditions such as @media, if they concern properties that are read.
    void read(std::string_view css, const Refuse& refuse);

    Style style_of(pugi::xml_node node) const;

private:
    struct Declaration {
        Property property;
        std::string value;
        bool is_important;
    };
    struct Selector {
        std::string element;  // empty: any
        std::vector<std::string> ids;
        std::vector<std::string> classes;
    };
    struct Rule {
        Selector selector;
        std::vector<Declaration> declarations;
    };

    std::vector<Declaration> declarations_of(std::string_view text) const;
    static bool read_selector(std::string_view text, Selector& selector);
    static bool fits(const Selector& selector, pugi::xml_node node);

    bool with_strokes_;
    std::vector<Rule> rules_;
};

}  // namespace lacuna::domains
