// Where cells are cut, and which pixels a sample may be said to lie on.
#include "verify/ground.h"

namespace lacuna::verify {

Cut Ground::cut(const Cell& cell, const Under& under) const {
    const Frame frame(cell);
    const bool is_wide = frame.half_width >= frame.half_height;
    if (!under.is_plain()) {
        const auto of_x = radii_.columns().middle_border(cell.left, cell.right);
        const auto of_y = radii_.rows().middle_border(cell.bottom, cell.top);
        if (of_x && (is_wide || !of_y)) return {true, *of_x};
        if (of_y) return {false, *of_y};
    }
    return {is_wide, is_wide ? frame.centre.x : frame.centre.y};
}

std::optional<SampleRadii> Ground::radii_of_sample(Point at) const {
    const RadiusRange range = radii_.near(at, kBorderBlur * domain_.longer_side());
    if (!range.has_any()) return std::nullopt;
    return SampleRadii{range.least, range.most};
}

}  // namespace lacuna::verify
