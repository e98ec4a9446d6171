// Walks around the pixels where points may not lie.
#include "places/mask_outlines.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "checks/classes.h"
#include "checks/pixels.h"

namespace lacuna::places {
namespace {

// The outlines of closed pixels, as steps from corner to corner of pixels with the closed pixel on
// the left. Corners are numbered from the lower left one, row by row.
class Walk {
public:
    Walk(const Mask& mask, const Domain& domain)
        : mask_(mask), domain_(domain), steps_((mask.columns + 1) * std::size_t{mask.rows + 1}) {
        for (std::int64_t row = 0; row < mask.rows; ++row) {
            ask_after(mask.columns);
            for (std::int64_t column = 0; column < mask.columns; ++column) {
                if (!is_closed(column, row)) continue;
                const std::array<bool, 4> beside{
                    is_closed(column, row - 1), is_closed(column + 1, row),
                    is_closed(column, row + 1), is_closed(column - 1, row)};
                const std::array<std::size_t, 4> corners{
                    corner(column, row), corner(column + 1, row), corner(column + 1, row + 1),
                    corner(column, row + 1)};
                for (unsigned way = 0; way < 4; ++way)
                    if (!beside[way]) steps_[corners[way]] |= 1U << way;
            }
        }
    }

    std::vector<PolygonRing> rings() {
        std::vector<PolygonRing> rings;
        for (std::size_t begin = 0; begin < steps_.size(); ++begin) {
            ask_after(1);
            while (steps_[begin] != 0) rings.push_back(ring_from(begin));
        }
        return rings;
    }

private:
    bool is_closed(std::int64_t column, std::int64_t row) const {
        return column >= 0 && row >= 0 && column < mask_.columns && row < mask_.rows &&
               mask_.allowed[static_cast<std::size_t>((mask_.rows - 1 - row) * mask_.columns +
                                                      column)] == 0;
    }
    std::size_t corner(std::int64_t column, std::int64_t row) const {
        return static_cast<std::size_t>(row * (std::int64_t{mask_.columns} + 1) + column);
    }
    Point place_of(std::size_t corner) const {
        const auto along = [](std::size_t step, std::uint32_t pixels, double from, double side) {
            return from + side * (static_cast<double>(step) / pixels);
        };
        const std::size_t across = std::size_t{mask_.columns} + 1;
        return {along(corner % across, mask_.columns, domain_.x0, domain_.width),
                along(corner / across, mask_.rows, domain_.y0, domain_.height)};
    }

    // Takes the steps of a ring away. Where two pixels touch at a corner alone, it stays at the
    // pixel that it goes around.
    PolygonRing ring_from(std::size_t begin) {
        const std::array<std::size_t, 4> ways{1, std::size_t{mask_.columns} + 1, ~std::size_t{0},
                                              ~std::size_t{mask_.columns}};
        PolygonRing ring;
        std::size_t at = begin;
        unsigned way = 4;
        do {
            unsigned next = way == 4 ? 0 : (way + 1) % 4;
            while ((steps_[at] >> next & 1U) == 0) next = (next + 3) % 4;
            if (next != way) ring.push_back(place_of(at));
            way = next;
            steps_[at] &= static_cast<std::uint8_t>(~(1U << way));
            at += ways[way];
        } while (at != begin);
        return ring;
    }

    const Mask& mask_;
    const Domain& domain_;
    std::vector<std::uint8_t> steps_;  // from each corner: bits for right, up, left and down
};

}  // namespace

void turn_masks_into_outlines(const Domain& domain, const Classes& classes, Places& places) {
    if (places.outlines.empty()) return;
    check_each(classes, "mask", places.masks.size(), " masks of classes");
    const auto add = [&](const Mask* mask, const std::string& of_class) {
        if (mask == nullptr) return;
        if (mask->drawn)
            throw BadRequest("mask", "drawn from polygons", "give the polygons themselves");
        check_mask(*mask);
        if (std::vector<PolygonRing> rings = Walk(*mask, domain).rings(); !rings.empty())
            places.outlines.push_back(
                {{.rings = std::move(rings)}, Role::outside, 0, of_class, false});
    };
    if (places.masks.empty()) add(places.mask, "");
    for (std::size_t i = 0; i < places.masks.size(); ++i) {
        const std::size_t first = kind_of(classes, i).first;  // an outline is for all sizes
        if (places.masks[i] != places.masks[first])
            throw BadRequest("mask", classes.names[i],
                             "beside outlines all sizes of a kind must have one mask");
        if (i == first)
            add(places.masks[i] != nullptr ? places.masks[i] : places.mask, classes.names[i]);
    }
    places.mask = nullptr;
    places.masks.clear();
}

}  // namespace lacuna::places
