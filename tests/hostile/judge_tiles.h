// Judges two tiles of one frame as one set.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "hostile/counts.h"
#include "hostile/judge_set.h"
#include "hostile/made.h"

namespace lacuna::tests {

// The values of pixels, twice beside each other.
template <typename Value>
std::vector<Value> doubled(const std::vector<Value>& values, std::uint32_t columns) {
    std::vector<Value> both;
    for (std::size_t row = 0; row * columns < values.size(); ++row)
        for (std::size_t i = 0; i < 2 * std::size_t{columns}; ++i)
            both.push_back(values[row * columns + i % columns]);
    return both;
}

inline void judge_tiles(const Made& made, const Result& left, const Result& right, Random& random,
                        Counts& counts) {
    Request both = made.request;
    both.keep = {};
    both.keep_classes = {};
    both.domain.width *= 2;
    Field field{2 * made.field.columns, made.field.rows,
                doubled(made.field.importance, made.field.columns),
                doubled(made.field.stretches, made.field.columns)};
    if (both.field != nullptr) both.field = &field;
    std::deque<Mask> masks;
    const auto double_mask = [&](const Mask*& mask) {
        if (mask == nullptr) return;
        masks.push_back({2 * mask->columns, mask->rows, doubled(mask->allowed, mask->columns)});
        mask = &masks.back();
    };
    double_mask(both.places.mask);
    for (const Mask*& mask : both.places.masks) double_mask(mask);
    // Moving the points of a tile rounds them.
    Set set{both};
    set.size = (both.field != nullptr ? left.scale : left.radius) * (1 - 1e-12);
    set.is_maximal = true;
    const double width = made.request.domain.width;
    for (const bool is_right : {false, true}) {
        const Result& tile = is_right ? right : left;
        for (const Point& at : tile.points)
            set.points.push_back(
                judge::wrapped(both.domain, {at.x + (is_right ? width : 0), at.y}));
        set.classes.insert(set.classes.end(), tile.classes.begin(), tile.classes.end());
    }
    const Judge judge = set.judge();
    demand(judge.fault().empty(), "two tiles: " + judge.fault());
    demand(judge.largest_gap(random).room <= judge.tolerance() * (1 + 1e-6), "two tiles have room");
    demand_proof(set, claim_of(set), "two tiles", counts);
}

}  // namespace lacuna::tests
