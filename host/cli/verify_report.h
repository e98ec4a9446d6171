// What `lacuna verify` says of point sets: as lines to be read, and as JSON.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <vector>

#include "verify/verify.h"

namespace lacuna::cli {

// A gap wider by more than this share of the radius is no rounding: a point taken out of a maximal
// set leaves its own place at least a radius from every other point, in the mean 1.054 radii, so
// that with a tolerance of some 5 % a set with holes would pass for maximal.
inline constexpr double kMostTolerance = 0.01;

// One set, what is claimed of it, and what was found.
struct Claim {
    std::string name;  // of the file, for messages
    const std::vector<Point>& points;
    double width;
    double height;
    bool torus;
    double radius;
    double tolerance;
    bool distances_only;        // whether there is room for a point was not asked
    bool meant_to_be_maximal;   // as far as its file tells
    verify::Verdict verdict{};  // with distances_only: but for what is said of the emptiest spot

    // Whether all that was asked holds.
    bool holds() const;
    // In words.
    std::string conclusion() const;
};

// Several sets are told apart by their names.
std::string text_of(const std::vector<Claim>& claims);
std::string json_of(const std::vector<Claim>& claims);

}  // namespace lacuna::cli
