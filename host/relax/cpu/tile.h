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

// What the last look at a leaf tells the next: who won in its middle, and within which power all
// that could win lay.
struct Hint {
    std::uint32_t site = NO_OWNER;
    std::uint64_t bound = 0;
};

// Works on one tile after the other, of at most kSide lattice points a side.
class Tile {
public:
    static constexpr std::uint32_t kSide = 32;
    static constexpr std::uint32_t kLeaf = 8;  // lattice points a side
    static constexpr std::uint32_t kLeavesOfSide = kSide / kLeaf;
    static constexpr std::uint32_t kLeaves = kLeavesOfSide * kLeavesOfSide;

    // Leaf number i is in column i % kLeavesOfSide and row i / kLeavesOfSide of the tile.
    static Box leaf_of(const Box& tile, std::uint32_t i);

    // Serves the leaves whose bits are set in `leaves`. The hints, one a leaf, make it fast and are
    // brought up to date. Leaves who owns each lattice point behind in `owners`, unless it is
    // empty: indices row by row of the whole lattice.
    void assign(const Scene& scene, const Box& box, std::uint32_t leaves, std::span<Hint> hints,
                std::span<std::uint32_t> owners = {});

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
    static constexpr std::size_t kLeafPoints = std::size_t{kLeaf} * kLeaf;

    // Where a site's power, less |p|^2, is at + u along_x + v along_y for lattice point (u, v) of
    // the tile: of two, the difference is exact, and no square is left.
    struct Candidate {
        std::int64_t at;
        std::int64_t along_x;
        std::int64_t along_y;
        Image image;
    };

    // Doubles hold whole numbers exactly: kMost times what a candidate is ahead of the first one,
    // plus its place in the list. Their least tells the winner, ties and all, and processors have
    // the least of two doubles in one instruction. With differences below kMostDifference, all that
    // is computed of them stays below 2^51: kMost * kMostDifference * (1 + 2 * kSide).
    static constexpr std::size_t kMost = 512;
    static constexpr std::int64_t kMostDifference = std::int64_t{1} << 35;

    // The same numbers in arrays, as whole numbers or, where they fit, doubles.
    template <typename Number>
    struct Planes {
        std::vector<Number> at;
        std::vector<Number> along_x;
        std::vector<Number> along_y;
        // Of the leaf that is served: at its lowest lattice point, and by how much it is behind the
        // first in the middle, wherever that is least.
        std::vector<Number> in_leaf;
        std::vector<Number> behind;

        void resize(std::size_t count);
    };

    void find_images();
    std::uint64_t bound_in(const Box& leaf, Hint& hint) const;
    Rectangle image_of(const Box& box, const Image& image) const;
    void find_candidates(std::uint64_t bound);
    void add_candidate(const Image& image);
    bool fill_doubles();
    void fill_whole();
    // Boxes are in lattice points of the tile from here on.
    static std::uint32_t place_in_list(double value);
    static std::size_t first_in_middle(const Planes<double>& planes, double right, double up);
    static std::size_t first_in_middle(const Planes<std::int64_t>& planes, std::int64_t right,
                                       std::int64_t up);
    template <typename Number>
    static void find_how_far_behind(Planes<Number>& planes, std::size_t first, Number width,
                                    Number height);
    static void find_behind(Planes<double>& planes, std::size_t first, double width, double height);
    static void find_behind(Planes<std::int64_t>& planes, std::size_t first, std::int64_t width,
                            std::int64_t height);
    template <typename Number>
    void keep_winners(Planes<Number>& planes, const Box& leaf, Number slack);
    void share_out(const Box& leaf);
    void fetch_masses(const Box& leaf);
    void find_owners_of_doubles();
    void find_owners();
    void add_to_parts(const Box& leaf);
    void write_owners(const Box& leaf);

    const Scene* scene_ = nullptr;
    Box box_{};  // of the tile
    std::span<std::uint32_t> owners_;
    std::array<Image, 9> images_{};  // of the domain
    std::size_t image_count_ = 0;
    std::vector<Candidate> candidates_;  // of the tile
    // Who comes first where two have the same power, from bit 30, and which candidate it is; below
    // all is in this order. 2^30 candidates would take 100 GB.
    static constexpr std::uint64_t kMostCandidates = std::uint64_t{1} << 30;
    std::vector<std::uint64_t> order_;
    bool has_doubles_ = false;
    Planes<double> doubles_;
    Planes<std::int64_t> whole_;
    // Four numbers that the compiler treats as one, or as two pairs. Aligned as all memory is.
    using Four = double __attribute__((vector_size(32), aligned(16)));
    struct Row {
        Four first[kLeaf / 4];
        Four up;
    };
    std::vector<Row> rows_;               // of the winners
    std::vector<std::uint32_t> winners_;  // candidates that may win in the leaf, in their order
    std::vector<Part> parts_;             // of the candidates
    // Of the candidates; those of the winners are in use. The masses are summed in two chains, as a
    // number that was just changed is slow to change again.
    static constexpr std::size_t kChains = 2;
    struct Sum {
        std::array<std::uint64_t, kChains> packed;
        std::uint64_t moment_y;
        std::uint64_t all() const { return packed[0] + packed[1]; }
    };
    std::vector<Sum> sums_;
    // Of a leaf's lattice points: what is summed of them, and which candidate owns them.
    std::array<std::uint64_t, kLeafPoints> masses_{};
    std::array<std::uint32_t, kLeafPoints> who_{};
};

}  // namespace lacuna::relaxing::cpu
