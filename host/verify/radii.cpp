// Looks up radii in the field.
#include "verify/radii.h"

namespace lacuna::verify {

Radii::Radii(const Domain& domain, const Field& field, double scale)
    : domain_(domain),
      columns_(domain.width, field.columns),
      rows_(domain.height, field.rows),
      pyramid_(Leaves{&field, scale}) {}

std::optional<double> Radii::at(Point place) const {
    const RadiusRange pixel =
        pyramid_.leaves().at(columns_.pixel_of(place.x), rows_.pixel_of(place.y));
    if (pixel.has_none) return std::nullopt;
    return pixel.least;
}

RadiusRange Radii::under(const Cell& cell) const {
    return pyramid_.over(columns_.between(cell.left, cell.right),
                         rows_.between(cell.bottom, cell.top));
}

RadiusRange Radii::all() const {
    return under({0, domain_.width, 0, domain_.height});
}

RadiusRange Radii::near(Point place, double blur) const {
    RadiusRange range;
    for (const double x : domain_.around(place.x, blur, domain_.width))
        for (const double y : domain_.around(place.y, blur, domain_.height))
            range += pyramid_.leaves().at(columns_.pixel_of(x), rows_.pixel_of(y));
    return range;
}

}  // namespace lacuna::verify
