// The reports of `lacuna verify` about sets in space: as text, and as JSON.
#pragma once

#include <lacuna/space.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lacuna::cli {

// One set, what is claimed of it, and what was found.
struct SpaceSetClaim : SpaceClaim {
    std::string name;       // of its file
    std::string mesh_name;  // of the file of its mesh; empty: it lies in the volume
    std::vector<Point3> points;
    bool meant_to_be_maximal = true;     // unless its file says that it is not
    std::string keep;                    // path of --keep, or empty
    std::optional<std::size_t> moved{};  // the first point that differs from that of --keep
    SpaceProof proof{};

    // Whether everything that was asked is true of the set.
    bool holds() const;
    // The verdict as a sentence.
    std::string conclusion() const;
};

// If there are several sets, the text names each of them.
std::string text_of(const std::vector<SpaceSetClaim>& claims);
std::string json_of(const std::vector<SpaceSetClaim>& claims);

}  // namespace lacuna::cli
