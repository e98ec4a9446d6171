// Samples in space, and what the reference and the cpu do alike with a part of a surface or a
// volume: draw from it, split it, and find out whether one sample covers it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "plan/plan.h"
#include "rounds/random.h"
#include "rounds/round.h"
#include "space/first_bins.h"

namespace lacuna::space {

// A sample, and on a surface where it lies on which triangle (portable/space.h).
struct SpaceSample {
    Position at;
    std::uint32_t triangle;
    std::uint32_t u;
    std::uint32_t v;
    friend bool operator==(const SpaceSample& a, const SpaceSample& b) {
        return portable::squared_distance(a.at, b.at) == 0 && a.triangle == b.triangle &&
               a.u == b.u && a.v == b.v;
    }
};

// From three words: of a volume the position, of a surface the triangle and (u, v).
inline SpaceSample sample_of_words(const FirstBins& all, std::uint32_t first, std::uint32_t second,
                                   std::uint32_t third) {
    if (all.is_volume()) {
        const auto whole = [](std::uint32_t word) { return static_cast<std::int32_t>(word); };
        return {{whole(first), whole(second), whole(third)}, 0, 0, 0};
    }
    return {portable::on_triangle(all.triangles[first], second, third), first, second, third};
}

// The third random number of a draw; the first chooses the bin.
inline std::uint32_t third_bits(const Plan& plan, std::uint64_t number) {
    return static_cast<std::uint32_t>(random_bits(plan.seed, number, 1).first >> 32U);
}

// The position in a part for 32 random bits along each axis.
inline SpaceSample drawn(const FirstBins& all, const Portion& part, std::uint32_t block,
                         std::array<std::uint32_t, 3> bits) {
    if (all.is_volume()) {
        const Solid box = all.cell(block);
        const Position low = low_corner(box, part), high = high_corner(box, part);
        return {{portable::drawn_on_side(low.x, high.x, bits[0]),
                 portable::drawn_on_side(low.y, high.y, bits[1]),
                 portable::drawn_on_side(low.z, high.z, bits[2])},
                0,
                0,
                0};
    }
    const auto [u, v] = portable::drawn_on_triangle(part, bits[0] >> 1U, bits[1] >> 1U);
    return {portable::on_triangle(all.triangles[part.third], u, v), part.third, u, v};
}

// The corners of a part: all of it lies within a ball if they do. A part that is no larger than a
// unit is its low corner, so that the splitting ends.
class Corners {
public:
    Corners(const FirstBins& all, const Portion& part, std::uint32_t block)
        : is_box_(all.is_volume()) {
        if (!is_box_) {
            const Solid& triangle = all.triangles[part.third];
            a_ = corner_of_triangle(triangle, part, 0);
            b_ = corner_of_triangle(triangle, part, 1);
            c_ = corner_of_triangle(triangle, part, 2);
            return;
        }
        const Solid box = all.cell(block);
        a_ = low_corner(box, part);
        b_ = high_corner(box, part);
        if (is_unit(a_, b_)) b_ = a_;
    }
    bool are_within(const Position& sample, std::uint64_t radius_squared) const {
        if (is_box_) return squared_distance_to_farthest(sample, a_, b_) < radius_squared;
        return squared_distance(sample, a_) < radius_squared &&
               squared_distance(sample, b_) < radius_squared &&
               squared_distance(sample, c_) < radius_squared;
    }
    // Whether the part is no larger than a unit.
    bool are_one() const { return is_box_ && squared_distance(a_, b_) == 0; }

private:
    bool is_box_;
    Position a_{}, b_{}, c_{};
};

inline bool can_be_split(const FirstBins& all, const Portion& part, std::uint32_t block) {
    return all.is_volume() ? !Corners(all, part, block).are_one() : !is_corner(part);
}
// Bins of less than a 16th of the mean weight wait: they would be split again and again before one
// of them is drawn. A triangle without area is such a bin.
inline std::uint64_t least_weight_to_split(std::uint64_t total, std::size_t bins) {
    return total / std::max<std::size_t>(bins, 1) / 16;
}
inline std::uint32_t pieces(const FirstBins& all) {
    return all.is_volume() ? 8 : 4;
}
// A box may have pieces without volume, whose weight is 0.
inline Portion piece_of(const FirstBins& all, const Portion& part, std::uint32_t which) {
    return all.is_volume() ? eighth(part, which) : quarter(part, which);
}

}  // namespace lacuna::space
