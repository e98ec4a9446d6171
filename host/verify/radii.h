// The radius of each place of the domain: that of the field's pixel under it.
#pragma once

#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/raster.h"

namespace lacuna::verify {

// What radii some pixels have.
struct RadiusRange {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    bool has_none = false;  // some pixel has no importance, and so no radius

    RadiusRange& operator+=(const RadiusRange& other) {
        least = std::min(least, other.least);
        most = std::max(most, other.most);
        has_none = has_none || other.has_none;
        return *this;
    }
    bool has_any() const { return most > 0; }
    bool is_one() const { return least == most && !has_none; }
};

class Radii {
public:
    // The field must outlive this; its values are finite and at least 0.
    Radii(const Domain& domain, const Field& field, double scale);

    // Nothing where there is no importance.
    std::optional<double> at(Point place) const;
    // Under a cell, perhaps with some pixels beside it.
    RadiusRange under(const Cell& cell) const;
    // Of every place of the domain.
    RadiusRange all() const;
    // Of pixels that a place may lie on when it is off by `blur` either way, around a torus' edges.
    RadiusRange near(Point place, double blur) const;

    const Axis& columns() const { return columns_; }
    const Axis& rows() const { return rows_; }

private:
    struct Leaves {
        using Summary = RadiusRange;
        const Field* field;
        double scale;

        std::uint32_t columns() const { return field->columns; }
        std::uint32_t rows() const { return field->rows; }
        RadiusRange at(std::uint32_t column, std::uint32_t row) const {
            const std::size_t from_top = field->rows - 1 - row;
            const double importance = field->importance[from_top * field->columns + column];
            if (importance == 0) return {.has_none = true};
            const double radius = scale / std::sqrt(importance);
            return {.least = radius, .most = radius};
        }
    };

    const Domain domain_;
    Axis columns_;
    Axis rows_;
    Pyramid<Leaves> pyramid_;
};

}  // namespace lacuna::verify
