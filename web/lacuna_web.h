// The functions that the page needs: one picture and one set at a time, like the command's stipple,
// sample, verify and analyze.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawing/picture.h"
#include "files/point_files.h"
#include "pictures/importance.h"

namespace lacuna::web {

// Is called with the fraction of the current work that is done, 0 to 1.
using Tell = std::function<void(double share)>;

// A picture in the layout of a browser's canvas.
struct Pixels {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::vector<std::uint8_t> rgba;
};

struct StippleOptions {
    pictures::Importance tone;
    std::optional<std::uint64_t> count;  // unset: a number that suits the picture, or the pen
    std::optional<Metric> metric;        // unset: the command's default
    std::uint32_t relax = 0;
    std::uint64_t seed = 0;
    std::optional<double> dot_size_mm;  // of a pen; unset: as much ink as the picture is dark
    std::optional<drawing::Sheet> sheet;
    bool pen_path = false;
    std::vector<Ink> inks;  // empty: black dots, of a grey picture
    double size_by_tone = 0;
    bool keep_inside = false;
};

struct Set {
    std::vector<Point> points;
    double width = 1;
    double height = 1;
    double radius = 0;  // 0 if it is not known
    Boundary boundary = Boundary::box;
    Mode mode = Mode::exact;
    std::uint64_t seed = 0;
    bool maximal = false;
    std::vector<files::Layer> layers;  // inks and their dots, which come ink by ink; or empty
    std::vector<double> diameters;     // empty: the same for all dots, from the radius
    drawing::Style style;              // without the diameters
    bool has_columns = false;  // whether csv and npy have columns for dots (pen or paper given)
};

// Keeps the black dots that were placed last. They are used again if only the number of iterations
// of relax or the drawing changes.
class Stippler {
public:
    // To be called before `pixels` change.
    void forget() { placed_.points.clear(); }

    // Throws what lacuna::sample and lacuna::relax throw.
    Set stipple(const Pixels& pixels, const StippleOptions& options, const Tell& tell);

private:
    // The options that decide which dots are placed, besides the pixels.
    struct Key {
        std::array<double, 5> tone{};
        bool auto_levels = false;
        bool invert = false;
        std::uint64_t count = 0;
        Mode mode = Mode::cells;
        Metric metric = Metric::min;
        std::uint64_t seed = 0;
        bool operator==(const Key&) const = default;
    };

    // The dots of a picture in one ink, before they are relaxed.
    Set placed_dots(const StippleOptions& options, const Request& request, const Tell& tell);

    Key key_;
    Set placed_;
};

// Throws what lacuna::sample and lacuna::relax throw.
Set sample(Request request, std::uint32_t relax, const Tell& tell);

// Whether the points are at least the radius apart and leave no gap.
Proof prove(const Set& set, double radius);

// The periodogram and its radial mean, for frequencies up to `most` * sqrt(count).
struct Spectrum {
    std::uint32_t side = 0;      // `powers` has side * side values
    std::vector<float> powers;   // row by row, with frequency 0 in the middle
    std::vector<double> radial;  // alternately frequency / sqrt(count) and power
};
Spectrum spectrum(const Set& set, double most, const Tell& tell);

// The bytes of the file that the command writes: csv, npy or svg. An svg contains the command line.
std::string encode(const Set& set, const std::string& format, const std::string& command);

}  // namespace lacuna::web
