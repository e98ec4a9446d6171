// What `lacuna verify` says of point sets: as lines to be read, and as JSON.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "cli/options/domain_options.h"

namespace lacuna::cli {

struct Extremes {
    double least;
    double most;
};

// One set, what is claimed of it, tolerance included, and what was found.
struct SetClaim : Claim {
    std::string name;                 // of the file, for messages
    std::span<const Point> points;    // they must outlive the claim
    bool meant_to_be_maximal = true;  // as far as its file tells
    DomainOptions options;
    nlohmann::ordered_json given;    // the same for reports
    Extremes radii{};                // of the field, or twice the one radius
    std::vector<PolygonRing> rings;  // of the polygons
    Proof proof;

    // One radius, and points may lie everywhere.
    bool is_plain() const {
        return field == nullptr && mask == nullptr && inside.empty() && border == 0;
    }

    // Whether all that was asked holds.
    bool holds() const;
    // In words.
    std::string conclusion() const;
};

// Several sets are told apart by their names.
std::string text_of(const std::vector<SetClaim>& claims);
std::string json_of(const std::vector<SetClaim>& claims);

}  // namespace lacuna::cli
