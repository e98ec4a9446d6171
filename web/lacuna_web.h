// What the page asks of Lacuna: one picture and one set at a time, as the command's stipple,
// sample, verify and analyze make them.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawing/picture.h"
#include "pictures/importance.h"

namespace lacuna::web {

// Told what share of the work at hand is done.
using Tell = std::function<void(double share)>;

// As a browser's canvas has it.
struct Pixels {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::vector<std::uint8_t> rgba;
};

struct StippleOptions {
    pictures::Importance tone;
    std::optional<std::uint64_t> count;  // none: what suits the picture, or a pen
    std::optional<Metric> metric;        // none: the command's own
    std::uint32_t relax = 0;
    std::uint64_t seed = 0;
    std::optional<double> dot_size_mm;  // of a pen; none: as much ink as the picture is dark
    std::optional<drawing::Sheet> sheet;
    bool pen_path = false;
};

struct Set {
    std::vector<Point> points;
    double width = 1;
    double height = 1;
    double radius = 0;  // 0 where it is not known
    Boundary boundary = Boundary::box;
    Mode mode = Mode::exact;
    std::uint64_t seed = 0;
    bool maximal = false;
    std::vector<double> diameters;  // empty: all alike, by the radius
    drawing::Style style;           // but for the diameters
    bool has_columns = false;       // of dots, in csv and npy: a pen or paper was given
};

// Keeps the dots that were placed last: whoever changes no more than how often they are relaxed, or
// how they are drawn, does not wait for them again.
class Stippler {
public:
    // `pixels` are others than before.
    void forget() { placed_.points.clear(); }

    // Throws what lacuna::sample and lacuna::relax throw.
    Set stipple(const Pixels& pixels, const StippleOptions& options, const Tell& tell);

private:
    // What decides which dots are placed, beside the pixels.
    struct Key {
        std::array<double, 3> levels{};
        bool auto_levels = false;
        bool invert = false;
        std::uint64_t count = 0;
        Metric metric = Metric::min;
        std::uint64_t seed = 0;
        bool operator==(const Key&) const = default;
    };

    Key key_;
    Set placed_;
};

// Throws what lacuna::sample and lacuna::relax throw.
Set sample(Request request, std::uint32_t relax, const Tell& tell);

// Whether the points keep the radius and leave no room.
Proof prove(const Set& set, double radius);

// The periodogram and its radial mean, of frequencies up to `most` times the square root of the
// count.
struct Spectrum {
    std::uint32_t side = 0;      // of the square of powers below
    std::vector<float> powers;   // DC in the middle; row by row
    std::vector<double> radial;  // frequency over sqrt(count), power, and so on
};
Spectrum spectrum(const Set& set, double most, const Tell& tell);

// The bytes of the command's file: csv, npy or svg, which tells the command line.
std::string encode(const Set& set, const std::string& format, const std::string& command);

}  // namespace lacuna::web
