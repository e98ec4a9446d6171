// Pictures in several inks: the dots of each ink are evenly spread, and so are all dots together.
//
// What is promised
//   - The same fields, numbers and seed give the same dots, bit for bit, on every backend and any
//     number of threads.
//   - Each ink has exactly its number of dots; each lies in the domain, on a pixel where the ink's
//     importance is not 0.
//   - Each dot has a cell among the dots of its ink, and another among all dots. Cells hold equal
//     importance, as in relax(). A dot moves onto the line between the two centroids, two thirds of
//     the way from the first cell's to the second's.
#pragma once

#include <lacuna/export.h>
#include <lacuna/relax.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace LACUNA_API lacuna {

using Colour = std::array<std::uint8_t, 3>;  // red, green and blue, in sRGB
inline constexpr Colour kWhitePaper{255, 255, 255};

// An ink, or a pen.
struct Ink {
    std::string name{};
    Colour colour{};    // on white paper; of an opaque ink, on any paper
    double pen_mm = 0;  // the width of the pen that draws it; 0: not given
    friend bool operator==(const Ink&, const Ink&) = default;

    // Whether the ink counts as opaque: it is lighter than the paper in some channel. Other inks
    // are transparent: the paper's numbers are multiplied by theirs.
    bool is_opaque_on(const Colour& paper) const {
        return colour[0] > paper[0] || colour[1] > paper[1] || colour[2] > paper[2];
    }
};

// How many dots of a set an ink has, or a class of points that is drawn in a colour.
struct Layer {
    Ink ink{};
    std::size_t dots = 0;
};

// What an ink prints, and how many dots it has.
struct InkPart {
    const Field* field = nullptr;  // all inks have fields of one size
    std::uint64_t dots = 0;        // at least 1
};

struct InkDots {
    std::vector<Point> points{};  // all of the first ink, then all of the second, and so on
    std::uint64_t lattice_columns = 0;
    std::uint64_t lattice_rows = 0;
    std::string backend{};
    std::string device{};
};

// Places the dots of up to 64 inks, and moves them options.iterations times, at least once. They
// begin stratified: dots are placed along a Hilbert curve, by the cdf of the density of all dots.
// Each gets one of the inks that its pixel needs: the ink that is furthest behind its own cdf at
// that point of the curve. Progress counts points times iterations. Throws what relax throws.
InkDots place_inks(std::span<const InkPart> inks, std::uint64_t seed, const RelaxOptions& options);
InkDots place_inks(std::span<const InkPart> inks, std::uint64_t seed, const RelaxOptions& options,
                   Observer& observer);

// Shares `dots` among inks in proportion to the sums of their importance, by largest remainders.
std::vector<std::uint64_t> dots_by_ink(std::uint64_t dots, std::span<const Field> inks);

}  // namespace lacuna
