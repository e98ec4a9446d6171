// Reads the properties of an SVG's elements that those within them inherit.
#include "domains/svg_inherited.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <system_error>

#include "files/parse.h"

namespace lacuna::domains {
namespace {

// Whether an element has what the one around it has.
bool is_left_to_outer(std::string_view value) {
    return value.empty() || value == "inherit" || value == "unset";
}

// The value of a property whose other values are read as if it were not given.
std::string_view one_of(const SvgElement& element, const Style& style, Property property,
                        std::initializer_list<std::string_view> values) {
    const std::string& value = style.of(property);
    if (is_left_to_outer(value) || value == "initial") return value;
    const auto* const found = std::find(values.begin(), values.end(), value);
    if (found == values.end())
        element.refuse(fmt::format("{} {}: must be {}", name_of(property), files::excerpt(value),
                                   fmt::join(values, ", ")));
    return *found;
}

// Whether a number hides what has it as its opacity.
bool is_unseen(std::string_view opacity) {
    double value = 1;
    return files::take_number(opacity, value) == std::errc{} && value <= 0;
}

void inherit_stroke(const SvgElement& element, const Style& style, Inherited& here) {
    const std::string& stroke = style.of(Property::stroke);
    if (!is_left_to_outer(stroke)) here.is_stroked = !is_none(stroke) && stroke != "transparent";
    const std::string& opacity = style.of(Property::stroke_opacity);
    if (!is_left_to_outer(opacity)) here.is_stroke_seen = !is_unseen(opacity);
    const std::string& width = style.of(Property::stroke_width);
    if (is_left_to_outer(width)) return;
    const std::optional<double> pixels = width == "initial" ? 1 : pixels_of(width);
    if (!pixels || !(*pixels >= 0) || !std::isfinite(*pixels))
        element.refuse(
            fmt::format("stroke-width is {}: must be a number of at least 0, of px, "
                        "mm, cm, in, pt or pc",
                        files::excerpt(width)));
    here.stroke_width = *pixels;
}

}  // namespace

bool is_none(std::string_view value) {
    return value.empty() || value == "none" || value == "initial" || value == "unset";
}

bool is_drawn(const SvgElement& element, const Style& style) {
    if (element.node().attribute("requiredExtensions")) return false;
    if (element.node().attribute("systemLanguage"))
        element.refuse("systemLanguage: what depends on the reader's language is not read");
    const std::string& display = style.of(Property::display);
    if (display.find('(') != std::string::npos)
        element.refuse(fmt::format("display {}: must be a word", files::excerpt(display)));
    return display != "none" && !is_unseen(style.of(Property::opacity));
}

Inherited inherited(const SvgElement& element, const Style& style, const Inherited& outer,
                    Take take) {
    Inherited here = outer;
    const std::string_view rule =
        one_of(element, style, Property::fill_rule, {"nonzero", "evenodd"});
    if (rule == "evenodd") here.fill = Fill::even_odd;
    if (rule == "nonzero" || rule == "initial") here.fill = Fill::nonzero;
    const std::string_view visibility =
        one_of(element, style, Property::visibility, {"visible", "hidden", "collapse"});
    if (visibility == "hidden" || visibility == "collapse") here.is_visible = false;
    if (visibility == "visible" || visibility == "initial") here.is_visible = true;
    const std::string& fill = style.of(Property::fill);
    if (!is_left_to_outer(fill)) here.is_filled = fill != "none";
    if (take == Take::strokes) inherit_stroke(element, style, here);
    for (const Property property :
         {Property::clip_path, Property::mask, Property::mask_image, Property::filter,
          Property::transform_origin, Property::transform_box, Property::translate,
          Property::rotate, Property::scale, Property::offset_path, Property::all})
        if (!is_none(style.of(property))) {
            here.changed = element.node();
            here.by = property;
        }
    return here;
}

double half_of_stroke(const SvgElement& element, const Style& style, const Inherited& here) {
    if (!here.is_stroked || !here.is_stroke_seen || here.stroke_width == 0) return 0;
    if (!is_none(style.of(Property::vector_effect)))
        element.refuse(fmt::format("vector-effect {}: is not read with the widths of strokes",
                                   files::excerpt(style.of(Property::vector_effect))));
    const std::optional<double> scale = here.transform.scale();
    if (!scale)
        element.refuse(
            fmt::format("its stroke of {} is stretched by a transform, and not equally "
                        "wide everywhere: give FILE:WIDTH",
                        here.stroke_width));
    return here.stroke_width / 2 * *scale;
}

}  // namespace lacuna::domains
