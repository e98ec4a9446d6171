// Who owns the lattice points of one tile, and what each owner gets of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "relax/cpu/site_tree.h"
#include "relax/lattice.h"

namespace lacuna::relaxing::cpu {

// Lattice points [left, right) x [bottom, top).
struct Box {
    std::uint32_t left;
    std::uint32_t bottom;
    std::uint32_t right;
    std::uint32_t top;
};

// All that a tile needs to know, and no tile changes.
struct Scene {
    const Lattice& lattice;
    const SiteTree& tree;
    std::span<const Site> sites;
    std::span<const std::uint32_t> indices;  // of the sites: ties go to the lowest
    std::span<const std::uint32_t> pixel_of_column;
    std::span<const std::uint32_t> pixel_of_row;
};

// One image of a site: periods by which it lies off the site itself. On a box always the site.
struct Image {
    std::uint32_t site;
    std::int16_t shift_x;
    std::int16_t shift_y;
};

// What the last look at a tile tells the next: who won in its middle, and within which power all
// that could win lay.
struct Hint {
    std::uint32_t site = NO_OWNER;
    std::uint64_t bound = 0;
};

// Works on one tile after the other, of at most kSide lattice points a side.
class Tile {
public:
    static constexpr std::uint32_t kSide = 16;

    // `hint` makes it fast and is brought up to date. Leaves who owns each lattice point behind in
    // `owners`, unless it is empty: indices row by row of the whole lattice.
    void own(const Scene& scene, const Box& box, Hint& hint, std::span<std::uint32_t> owners = {});

    // What one image got. Moments are from the tile's lowest lattice point.
    struct Part {
        Image image;
        std::uint32_t points;
        std::uint64_t mass;
        std::uint64_t moment_x;
        std::uint64_t moment_y;
    };
    std::span<const Part> parts() const { return parts_; }

private:
    static constexpr std::uint32_t kLeaf = 8;  // lattice points a side
    static constexpr std::size_t kLeafPoints = std::size_t{kLeaf} * kLeaf;

    // Where a site's power, less |p|^2, is at + u along_x + v along_y for lattice point (u, v) of
    // the tile: of two, the difference is exact, and no square is left.
    struct Candidate {
        std::int64_t at;
        std::int64_t along_x;
        std::int64_t along_y;
        std::uint64_t order;  // of ties
        std::uint32_t part;

        std::int64_t value(std::int64_t u, std::int64_t v) const {
            return at + u * along_x + v * along_y;
        }
    };

    void find_candidates(const Box& box, Hint& hint);
    void add_candidate(const Image& image);
    Rectangle image_of(const Box& box, const Image& image) const;
    // Boxes are in lattice points of the tile from here on.
    std::size_t winner_in_middle(const Box& box) const;
    void keep_winners(const Box& box, const Candidate& winner);
    void share_out(const Box& box);
    void fetch_masses(const Box& box);
    bool find_owners_fast(const Box& box);
    void find_owners(const Box& box);
    void add_to_parts(const Box& box);
    void write_owners(const Box& box);

    const Scene* scene_ = nullptr;
    std::uint32_t left_ = 0;  // of the tile
    std::uint32_t bottom_ = 0;
    std::span<std::uint32_t> owners_;
    std::vector<Candidate> candidates_;  // of the tile
    std::vector<Candidate> winners_;     // those that may win in one leaf of it
    std::vector<Part> parts_;
    struct Sum {
        std::uint64_t packed;
        std::uint64_t moment_y;
    };
    std::vector<Sum> sums_;  // of the winners
    // Of a leaf's lattice points: what is summed of them, and who owns them by the place in
    // winners_.
    std::array<std::uint64_t, kLeafPoints> masses_{};
    std::array<std::uint64_t, kLeafPoints> who_{};
};

}  // namespace lacuna::relaxing::cpu
