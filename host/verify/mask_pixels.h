// Where a mask lets samples lie.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/raster.h"

namespace lacuna::verify {

// What some pixels of a mask are.
struct Openness {
    bool has_open = false;
    bool has_closed = false;

    Openness& operator+=(const Openness& other) {
        has_open = has_open || other.has_open;
        has_closed = has_closed || other.has_closed;
        return *this;
    }
};

class MaskPixels {
public:
    // The mask must outlive this.
    MaskPixels(const Domain& domain, const Mask& mask)
        : domain_(domain),
          columns_(domain.width, mask.columns),
          rows_(domain.height, mask.rows),
          pyramid_(Leaves{&mask}) {}

    bool is_open(Point place) const {
        return pyramid_.leaves().at(columns_.pixel_of(place.x), rows_.pixel_of(place.y)).has_open;
    }
    // Under a cell, perhaps with some pixels beside it.
    Openness under(const Cell& cell) const {
        return pyramid_.over(columns_.between(cell.left, cell.right),
                             rows_.between(cell.bottom, cell.top));
    }
    // Whether a place may be on an open pixel when it is off by `blur` either way.
    bool is_open_near(Point place, double blur) const {
        for (const double x : domain_.around(place.x, blur, domain_.width))
            for (const double y : domain_.around(place.y, blur, domain_.height))
                if (is_open({x, y})) return true;
        return false;
    }

    const Axis& columns() const { return columns_; }
    const Axis& rows() const { return rows_; }

private:
    struct Leaves {
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

    const Domain domain_;
    Axis columns_;
    Axis rows_;
    Pyramid<Leaves> pyramid_;
};

}  // namespace lacuna::verify
