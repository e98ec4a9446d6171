// The functions that the page needs: one picture and one set at a time, like the command's stipple,
// sample, verify and analyze. Options are given as on a command line, and read by the same rules.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawing/picture.h"
#include "files/point_files.h"
#include "options/options.h"

namespace lacuna::web {

// Is called with the fraction of the current work that is done, 0 to 1.
using Tell = std::function<void(double share)>;

// A picture in the layout of a browser's canvas.
struct Pixels {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::vector<std::uint8_t> rgba;
};

struct Set {
    std::vector<Point> points;
    Domain domain{};
    double radius = 0;  // 0 if it is not known
    Mode mode = Mode::exact;
    std::uint64_t seed = 0;
    bool maximal = false;
    std::vector<files::Layer> layers;  // inks and their dots, which come ink by ink; or empty
    std::vector<double> diameters;     // empty: the same for all dots, from the radius
    std::vector<Ellipse> ellipses;     // of --along: ellipses or strokes; or empty
    drawing::Style style;              // without the diameters
    std::optional<Mask> mask;          // where points may lie
    std::string plot;                  // how long a pen's path and a plot are, in words; or empty
    bool has_columns = false;  // whether csv and npy have columns for dots (pen or paper given)
    std::string command;       // the command line that makes the same set
};

// The command line of stipple or sample with these options, in the order of the table. Throws
// BadRequest for an option that the command does not have, a text that is no value of its option,
// and options that exclude or need each other.
std::string command_of(options::CommandLine line);

// The set of the command line: dots of the picture for stipple; for sample the picture is the mask,
// if one is given. Throws what command_of, lacuna::stipple, lacuna::sample and lacuna::relax throw.
Set make(const Pixels& pixels, options::CommandLine line, const Tell& tell);

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
std::string encode(const Set& set, const std::string& format);

}  // namespace lacuna::web
