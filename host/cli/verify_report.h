// What `lacuna verify` says of point sets: as lines to be read, and as JSON.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <vector>

#include "verify/verify.h"

namespace lacuna::cli {

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
