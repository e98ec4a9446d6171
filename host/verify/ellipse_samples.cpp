// Asks the radius field for the ellipses of each sample.
#include "verify/ellipse_samples.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <variant>

namespace lacuna::verify {

EllipseSamples::EllipseSamples(std::span<const Point> points, const RadiusField& radius_field,
                               Proof& proof) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point from_corner = radius_field.domain().from_corner(points[i]);
        const auto found = radius_field.shapes_of_sample(from_corner);
        if (const auto* closed = std::get_if<Proof::Closed>(&found)) {
            proof.forbidden = i;
            proof.forbidden_by = *closed;
            return;
        }
        for (const EllipseShape* shape : std::get<0>(found)) {
            shapes_.push_back(shape);
            each_.push_back({from_corner, shape});
        }
        ends.push_back(shapes_.size());
    }
    std::size_t begin = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto shapes = std::span(shapes_).subspan(begin, ends[i] - begin);
        double radius = std::numeric_limits<double>::infinity();
        for (const EllipseShape* shape : shapes) radius = std::min(radius, shape->longer);
        blurred_.push_back({points[i], radius, shapes});
        begin = ends[i];
    }
}

Pair EllipseSamples::closest_pair(const RadiusField& radius_field, const Patience& patience) const {
    return verify::closest_pair(radius_field.domain(), blurred_, patience, kHopeless);
}

Gap EllipseSamples::largest_gap(const RadiusField& radius_field, double tolerance,
                                const Patience& patience) const {
    return verify::largest_gap(radius_field, each_, tolerance, patience);
}

}  // namespace lacuna::verify
