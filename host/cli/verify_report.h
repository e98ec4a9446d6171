// What `lacuna verify` says of point sets: as lines to be read, and as JSON.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <string>
#include <vector>

namespace lacuna::cli {

// One set, what is claimed of it, tolerance included, and what was found.
struct SetClaim : Claim {
    std::string name;  // of the file, for messages
    const std::vector<Point>& points;
    bool meant_to_be_maximal;  // as far as its file tells
    Proof proof{};

    // Whether all that was asked holds.
    bool holds() const;
    // In words.
    std::string conclusion() const;
};

// Several sets are told apart by their names.
std::string text_of(const std::vector<SetClaim>& claims);
std::string json_of(const std::vector<SetClaim>& claims);

}  // namespace lacuna::cli
