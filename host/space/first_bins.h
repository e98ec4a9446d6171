// The surface or the volume of a plan, in whole numbers: its first bins, and which blocks of them a
// sample may reach (docs/space.md).
#pragma once

#include <lacuna/space.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "portable/space.h"

namespace lacuna::space {

using portable::Portion;
using portable::Position;
using portable::Solid;

using portable::size_of;

// Coordinates begin at the lower corner of the box around the surface, or of the volume, whose
// longest side has 2^30 units.
//
// Bins lie in blocks. Each block is what the cell of a grid holds: of a surface the bins whose
// middle lies in the cell, of a volume the cell itself. A sample belongs to the block of its bin.
struct FirstBins {
    std::vector<Portion> bins{};          // block by block
    std::vector<std::uint32_t> begins{};  // of each block, its first bin; then their number
    // Samples that exist already, block by block.
    std::vector<Position> kept{};
    std::vector<std::uint32_t> kept_begins{};

    // Of a surface: the triangles that samples may lie on, with their weights, in proportion to
    // their areas and at least 1, and their numbers in the mesh. Long and thin ones are cut in two
    // first, until they can be split into four like others.
    std::vector<Solid> triangles{};
    std::vector<std::uint64_t> weights{};
    std::vector<std::uint32_t> numbers{};
    // Empty if none was cut in two. Else for each of them the barycentric shares of its three
    // corners: those of the second and of the third corner of the mesh's triangle.
    std::vector<std::array<std::array<double, 2>, 3>> cut_from{};
    // For each block the blocks whose samples may be closer than the radius to a spot of its bins,
    // itself included: from near_begins[block] up to near_begins[block + 1].
    std::vector<std::uint32_t> near{};
    std::vector<std::uint32_t> near_begins{};

    // Of a volume: its sides in units, and how many cells each is cut into.
    std::array<std::int32_t, 3> sides{};
    std::array<std::uint32_t, 3> cells{};
    bool wraps = false;

    bool is_volume() const { return triangles.empty(); }
    std::size_t blocks() const { return begins.size() - 1; }

    Solid cell(std::uint32_t block) const {
        const Position counts = cell_counts();
        return cell_at(sides_of_volume(), counts, place_of_cell(counts, block));
    }
    Position sides_of_volume() const { return {sides[0], sides[1], sides[2]}; }
    Position cell_counts() const {
        return {static_cast<std::int32_t>(cells[0]), static_cast<std::int32_t>(cells[1]),
                static_cast<std::int32_t>(cells[2])};
    }
    std::uint64_t weight_of(const Portion& part, std::uint32_t block) const {
        return weight_of(part, is_volume() ? cell(block) : Solid{});
    }
    // `cell` is that of its block; on a surface it does not count.
    std::uint64_t weight_of(const Portion& part, const Solid& cell) const {
        if (!is_volume()) return weight_of_triangle(weights[part.third], part);
        return weight_of_box(low_corner(cell, part), high_corner(cell, part));
    }

    // Calls visit(block, shift) for the blocks whose samples may be closer than the radius to a
    // position of this block, once they are moved by `shift`, which is not 0 around the edges of a
    // torus.
    template <typename Visit>
    void for_each_near(std::uint32_t block, const Visit& visit) const {
        if (!is_volume()) {
            for (std::uint32_t i = near_begins[block]; i < near_begins[block + 1]; ++i)
                visit(near[i], Position{0, 0, 0});
            return;
        }
        const Position counts = cell_counts(), place = place_of_cell(counts, block);
        for (std::uint32_t which = 0; which < NEAR_CELLS; ++which) {
            const portable::NearCell other =
                near_cell(sides_of_volume(), counts, wraps, place, which);
            if (other.exists) visit(other.number, other.shift);
        }
    }
};

// The units of a plan, and the way back to the user's.
struct Units {
    Point3 low{};          // the user's position of (0, 0, 0)
    Point3 unit{1, 1, 1};  // along each axis, in the user's unit of length; all nearly equal

    Point3 to_user(const Position& position) const {
        return {low.x + position.x * unit.x, low.y + position.y * unit.y,
                low.z + position.z * unit.z};
    }
    Position position_of(const Point3& point) const;
};

// Cuts the mesh's allowed triangles into bins no longer than some radii, and puts them and the kept
// points into blocks.
FirstBins bins_of_surface(const Mesh& mesh, std::span<const std::uint8_t> allowed,
                          const Units& units, std::uint64_t radius, std::span<const Position> kept);
FirstBins bins_of_volume(std::array<std::int32_t, 3> sides, bool wraps, std::uint64_t radius,
                         std::span<const Position> kept);

}  // namespace lacuna::space
