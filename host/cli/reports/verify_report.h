// The reports of `lacuna verify` about point sets: as text, and as JSON.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <memory>
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

// One set, what is claimed of it, and what was found. The tolerance is always set.
struct SetClaim : Claim {
    std::string name;                 // the name of its file, for messages
    std::span<const Point> points;    // the points must outlive the claim
    bool meant_to_be_maximal = true;  // unless its file says that it is not
    DomainOptions options;
    nlohmann::ordered_json given;  // the options, for reports
    Extremes radii{};              // of the field; both are the radius if there is no field
    std::shared_ptr<const Field> own_field;     // of the ellipse that its file says all have
    std::vector<std::uint8_t> own_classes;      // of the points
    std::vector<std::uint8_t> classes_of_keep;  // of the points to keep
    Proof proof;
    std::vector<Level> levels;  // of a progressive order
    std::string fault;          // of the first level that does not hold, or empty

    // Whether everything that was asked is true of the set.
    bool holds() const;
    // The verdict as a sentence.
    std::string conclusion() const;
};

// If there are several sets, the text names each of them.
std::string text_of(const std::vector<SetClaim>& claims);
std::string json_of(const std::vector<SetClaim>& claims);

}  // namespace lacuna::cli
