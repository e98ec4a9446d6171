// What an element of an SVG drawing hands on to those within it.
#pragma once

#include <pugixml.hpp>
#include <string_view>

#include "domains/join.h"
#include "domains/outline.h"
#include "domains/rings.h"
#include "domains/svg_element.h"
#include "domains/svg_style.h"

namespace lacuna::domains {

struct Inherited {
    Affine transform;
    Fill fill;
    bool is_filled = true;
    bool is_visible = true;
    bool is_chosen = true;  // whether the element lies in the layer that is read
    // An element that changes where its shapes are in a way that is not read, and its property.
    pugi::xml_node changed{};
    Property by{};
    // Only where strokes are read.
    bool is_stroked = false;
    bool is_stroke_seen = true;  // by its opacity
    double stroke_width = 1;     // before the transform
};

// Whether the value of a property is as good as none.
bool is_none(std::string_view value);

// Whether an element and what is in it may be drawn at all. Throws FileError.
bool is_drawn(const SvgElement& element, const Style& style);

// What an element hands on, without its own transform. Throws FileError.
Inherited inherited(const SvgElement& element, const Style& style, const Inherited& outer,
                    Take take);

// Half of the width that an element's stroke has on the page; 0 if it has no stroke. Throws
// FileError if it is not equally wide everywhere.
double half_of_stroke(const SvgElement& element, const Style& style, const Inherited& here);

}  // namespace lacuna::domains
