// Pictures stretched over the domain: the radii that a field gives, and where a mask allows
// samples.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/raster.h"

namespace lacuna::verify {

// The radii that some pixels have. An ellipse has all radii from its shorter to its longer one.
struct RadiusRange {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    bool has_none = false;  // some pixel has importance 0, and so no radius

    RadiusRange& operator+=(const RadiusRange& other) {
        least = std::min(least, other.least);
        most = std::max(most, other.most);
        has_none = has_none || other.has_none;
        return *this;
    }
    bool has_any() const { return least <= most; }
    bool is_one() const { return least == most && !has_none; }
};

// Whether samples may lie on some pixels of a mask.
struct Openness {
    bool has_open = false;
    bool has_closed = false;

    Openness& operator+=(const Openness& other) {
        has_open = has_open || other.has_open;
        has_closed = has_closed || other.has_closed;
        return *this;
    }
};

// The pixels of a picture, stretched over the domain. Pyramid says what `Leaves` must have.
template <typename Leaves>
class Pixels {
public:
    using Summary = typename Leaves::Summary;

    Pixels(const Domain& domain, const Leaves& leaves)
        : domain_(domain),
          columns_(domain.width, leaves.columns()),
          rows_(domain.height, leaves.rows()),
          pyramid_(leaves) {}

    Summary at(Point place) const {
        return pyramid_.leaves().at(columns_.pixel_of(place.x), rows_.pixel_of(place.y));
    }
    // The pixels under a cell, and perhaps some pixels beside it.
    Summary under(const Cell& cell) const {
        return pyramid_.over(columns_.between(cell.left, cell.right),
                             rows_.between(cell.bottom, cell.top));
    }
    Summary all() const { return under({0, domain_.width, 0, domain_.height}); }
    // The pixels on which a place may lie if each of its coordinates is off by up to `blur`.
    Summary near(Point place, double blur) const {
        Summary sum;
        for (const double x : domain_.around(place.x, blur, domain_.width))
            for (const double y : domain_.around(place.y, blur, domain_.height)) sum += at({x, y});
        return sum;
    }

    const Axis& columns() const { return columns_; }
    const Axis& rows() const { return rows_; }

private:
    const Domain domain_;
    Axis columns_;
    Axis rows_;
    Pyramid<Leaves> pyramid_;
};

// The field must outlive this; its values are finite and at least 0.
struct FieldLeaves {
    using Summary = RadiusRange;
    const Field* field;
    double scale;

    std::uint32_t columns() const { return field->columns; }
    std::uint32_t rows() const { return field->rows; }
    RadiusRange at(std::uint32_t column, std::uint32_t row) const {
        const std::size_t from_top = field->rows - 1 - row;
        const std::size_t pixel = from_top * field->columns + column;
        const double importance = field->importance[pixel];
        if (importance == 0) return {.has_none = true};
        const double radius = scale / std::sqrt(importance);
        if (field->stretches.empty()) return {.least = radius, .most = radius};
        const double root = std::sqrt(field->stretches[pixel].ratio);
        return {.least = radius / root, .most = radius * root};
    }
};

// The mask must outlive this.
struct MaskLeaves {
    using Summary = Openness;
    const Mask* mask;

    std::uint32_t columns() const { return mask->columns; }
    std::uint32_t rows() const { return mask->rows; }
    Openness at(std::uint32_t column, std::uint32_t row) const {
        const std::size_t from_top = mask->rows - 1 - row;
        const bool is_open = mask->allowed[from_top * mask->columns + column] != 0;
        return {is_open, !is_open};
    }
};

}  // namespace lacuna::verify
