// An element of an SVG drawing: its lengths, and the outline of a shape.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "domains/outline.h"
#include "domains/svg_style.h"

namespace lacuna::domains {

// The name without a namespace prefix.
std::string_view local_name(const char* name);

// The namespace that a prefix, or none, stands for in an element. Empty if it is not declared.
std::optional<std::string_view> namespace_of(pugi::xml_node node, std::string_view prefix);

// The name of an element of SVG, and an empty one for an element of another namespace. Without any
// namespace a file is taken for SVG. Throws FileError, which names `file`, for an unknown prefix.
std::string_view svg_name(const std::string& file, pugi::xml_node node);

// The viewBox, or the width and height of an <svg>.
struct SvgPage {
    double left;
    double top;
    double width;
    double height;
};
// Throws FileError, which names `file`.
SvgPage page_of(const std::string& file, pugi::xml_node svg);

// What `use` draws: its href, which may be one of XLink.
std::string_view link_of(pugi::xml_node node);

// A length in px, which is 1/96 of an inch.
std::optional<double> pixels_of(std::string_view text);

// Whether an element of this name is a shape that has an inside.
bool is_shape(std::string_view name);

// The only element with this id or, if there is none, with this label of Inkscape. `file` is named
// in messages. Throws FileError.
pugi::xml_node find_layer(const std::string& file, pugi::xml_node root, std::string_view layer);

class SvgElement {
public:
    // `file` is named in messages, and must outlive the element.
    SvgElement(const std::string& file, pugi::xml_node node) : file_(file), node_(node) {}

    pugi::xml_node node() const { return node_; }
    // Throws FileError that names the file and the element.
    [[noreturn]] void refuse(const std::string& why) const;
    void check(const std::optional<std::string>& wrong) const {
        if (wrong) refuse(*wrong);
    }

    // An attribute's length in px. Throws FileError.
    double number(const char* key, double otherwise) const;

    // Style sheets may give sizes, too, in place of attributes: these are refused with FileError.
    void check_sizes(const Style& style) const;

    // Draws a shape or a line. Throws FileError.
    void draw(Outline& outline) const;

private:
    // A length of at least 0.
    double size(const char* key, double otherwise) const;
    void draw_ellipse(double rx, double ry, Outline& outline) const;
    void draw_rect(Outline& outline) const;

    const std::string& file_;
    pugi::xml_node node_;
};

}  // namespace lacuna::domains
