// Assigns the lattice points of one tile, and sums the mass and moments that each site gets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lattice/lattice.h"
#include "relax/cpu/site_tree.h"

namespace lacuna::relaxing::cpu {

// Lattice points [left, right) x [bottom, top).
struct Box {
    std::uint32_t left;
    std::uint32_t bottom;
    std::uint32_t right;
    std::uint32_t top;
};

// The data that all tiles read and no tile changes.
struct Scene {
    const Lattice& lattice;
    const SiteTree& tree;
    std::span<const Site> sites;
    std::span<const std::uint32_t> indices;  // of the sites: ties go to the lowest
    std::span<const std::uint32_t> pixel_of_column;
    std::span<const std::uint32_t> pixel_of_row;
};

// An image of a site, shifted by whole periods. On a box it is always the site itself.
struct Image {
    std::uint32_t site;
    std::int16_t shift_x;
    std::int16_t shift_y;
};

// A leaf's result that helps the next search: the site that won in its middle, and an upper bound
// of the power of the sites that could win.
struct Hint {
    std::uint32_t site = NO_OWNER;
    std::uint64_t bound = 0;
};

// Works on one tile after the other, each at most kSide lattice points wide and high.
class Tile {
public:
    static constexpr std::uint32_t kSide = 32;
    static constexpr std::uint32_t kLeaf = 8;  // lattice points along a side
    static constexpr std::uint32_t kLeavesOfSide = kSide / kLeaf;
    static constexpr std::uint32_t kLeaves = kLeavesOfSide * kLeavesOfSide;

    // Leaf i is in column i % kLeavesOfSide and row i / kLeavesOfSide of the tile.
    static Box leaf_of(const Box& tile, std::uint32_t i);

    // Assigns the leaves whose bits are set in `leaves`. The hints, one for each leaf, make it fast
    // and are updated. Unless `owners` is empty, it gets the owner of each lattice point; it has an
    // entry for each point of the whole lattice, row by row.
    void assign(const Scene& scene, const Box& box, std::uint32_t leaves, std::span<Hint> hints,
                std::span<std::uint32_t> owners = {});

    // What is assigned to one image. Moments are relative to the tile's lowest lattice point.
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

    // A site's power at lattice point (u, v) of the tile, minus |p|^2, is at + u along_x + v
    // along_y. The difference of two of these is exact and contains no square.
    struct Candidate {
        std::int64_t at;
        std::int64_t along_x;
        std::int64_t along_y;
        Image image;
    };

    // Candidates are compared as doubles, which hold whole numbers exactly: kMost times the
    // difference to the first candidate, plus the candidate's index in the list. The least of them
    // is the winner, ties included, and takes one instruction to find. With differences below
    // kMostDifference all results are below 2^51: kMost * kMostDifference * (1 + 2 * kSide).
    static constexpr std::size_t kMost = 512;
    static constexpr std::int64_t kMostDifference = std::int64_t{1} << 35;

    // The candidates' numbers as arrays of whole numbers or, where these fit, of doubles.
    template <typename Number>
    struct Planes {
        std::vector<Number> at;
        std::vector<Number> along_x;
        std::vector<Number> along_y;
        // For the current leaf: the value at its lowest lattice point, and the least distance
        // behind the candidate that is first in the leaf's middle.
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
    // From here on boxes are in lattice points of the tile.
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
    Box box_{};  // the tile
    std::span<std::uint32_t> owners_;
    std::array<Image, 9> images_{};  // images of the domain
    std::size_t image_count_ = 0;
    std::vector<Candidate> candidates_;  // for the tile
    // The candidates in the order that decides ties, which all lists below use: bits 30 and up hold
    // the rank, lower bits the candidate's index. 2^30 candidates would take 100 GB.
    static constexpr std::uint64_t kMostCandidates = std::uint64_t{1} << 30;
    std::vector<std::uint64_t> order_;
    bool has_doubles_ = false;
    Planes<double> doubles_;
    Planes<std::int64_t> whole_;
    // A vector of four doubles. Its alignment is the alignment of all allocated memory.
    using Four = double __attribute__((vector_size(32), aligned(16)));
    struct Row {
        Four first[kLeaf / 4];
        Four up;
    };
    std::vector<Row> rows_;               // one for each winner
    std::vector<std::uint32_t> winners_;  // candidates that may win in the leaf, in ties' order
    std::vector<Part> parts_;             // one for each candidate
    // One for each candidate; only the winners' are in use. The masses are summed in two chains,
    // because a number that was just changed is slow to change again.
    static constexpr std::size_t kChains = 2;
    struct Sum {
        std::array<std::uint64_t, kChains> packed;
        std::uint64_t moment_y;
        std::uint64_t all() const { return packed[0] + packed[1]; }
    };
    std::vector<Sum> sums_;
    std::uint32_t exponent_ = 0;  // of the leaf's masses
    // For each lattice point of a leaf: its mass and count, packed, and the candidate that gets it.
    std::array<std::uint64_t, kLeafPoints> masses_{};
    std::array<std::uint32_t, kLeafPoints> who_{};
};

}  // namespace lacuna::relaxing::cpu
