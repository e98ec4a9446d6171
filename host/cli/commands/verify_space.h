// The run of `lacuna verify` for sets on meshes and in volumes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "files/read_points.h"
#include "files/read_whole.h"
#include "options/space.h"

namespace lacuna::cli {

// What the options say of all sets, and the sets.
struct SpaceVerification {
    const options::InSpace& space;
    std::optional<double> tolerance;
    bool distances_only;
    bool json;
    const std::string& keep;
    const std::vector<std::string>& paths;
    const std::vector<files::PointsOfFile>& files;
};

struct SpaceVerdicts {
    std::string report;
    bool all_hold;
};

// Proves what the options, and the files where no option says it, claim of each set. Throws
// BadRequest, BadUsage and files::FileError.
SpaceVerdicts verified_in_space(const CommandLine& line, const SpaceVerification& asked);

}  // namespace lacuna::cli
