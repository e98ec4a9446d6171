// Rounds ellipses: the map has 31 bits for its largest coefficient.
#include "plan/ellipse.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/number_text.h"

namespace lacuna {

Ellipse stretched(double radius, const Stretch& stretch) {
    const double root = std::sqrt(stretch.ratio);
    return {radius * root, radius / root, stretch.angle};
}

QuadraticForm form_of(const Ellipse& radii) {
    const auto& [c, s] = direction_of(radii.angle);
    const double far = 1 / (radii.a * radii.a);
    const double near = 1 / (radii.b * radii.b);
    return {c * c * far + s * s * near, c * s * (far - near), s * s * far + c * c * near};
}

RoundedEllipse rounded(const Ellipse& radii, const GridOfEllipses& grid) {
    const double unit = std::min(grid.unit_x, grid.unit_y);
    // With a shorter radius of the diagonal an ellipse holds the whole domain.
    const double within = std::min(1.0, grid.most * unit / radii.b);
    const double a = radii.a * within;
    const double b = radii.b * within;
    // A coefficient of the map is off by 2^-32 of the largest one, which is about 1 / b; so (u, v)
    // is off by 1.5 a / b times that on an offset of length a.
    const double off = a / b * 0x1p-30;
    const double more = grid.more * std::max(grid.unit_x, grid.unit_y) + grid.lost;
    const Ellipse enlarged{a * (1 + off) + more, b * (1 + off) + more, radii.angle};
    QuadraticForm form = form_of(enlarged);
    form = {form.xx * grid.unit_x * grid.unit_x, form.xy * grid.unit_x * grid.unit_y,
            form.yy * grid.unit_y * grid.unit_y};
    // The Cholesky factor of the form, with dy last. Its determinant is known from the radii, and
    // would lose digits as a difference.
    const double root = std::sqrt(form.yy);
    const double p =
        ELLIPSE_RADIUS * (grid.unit_x * grid.unit_y) / (enlarged.a * enlarged.b * root);
    const double q = ELLIPSE_RADIUS * form.xy / root;
    const double s = ELLIPSE_RADIUS * root;
    const int shift = 30 - std::ilogb(std::max({p, std::abs(q), s}));
    const auto whole = [shift](double value) {
        return static_cast<std::uint32_t>(std::llround(std::ldexp(value, shift)));
    };
    const double outer = std::min(enlarged.a / unit * (1 + 2 * off) + 3, grid.most);
    return {{whole(p), whole(q), whole(s), static_cast<std::uint32_t>(shift)},
            static_cast<std::uint32_t>(b / std::max(grid.unit_x, grid.unit_y)),
            static_cast<std::uint32_t>(std::ceil(outer))};
}

}  // namespace lacuna
