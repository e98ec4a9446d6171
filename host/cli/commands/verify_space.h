// The run of `lacuna verify` for sets on meshes and in volumes.
#pragma once

#include <lacuna/space.h>

#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "cli/reports/verify_space_report.h"
#include "files/read_points.h"
#include "options/space.h"

namespace lacuna::cli {

// What the options say of all sets.
struct SpaceClaimOptions {
    const options::InSpace& space;
    std::optional<double> tolerance;
    bool distances_only;
    std::string keep;  // path
};

// Proves what the options, and the files where no option says it, claim of each set. Throws
// BadRequest, BadUsage and files::FileError.
std::vector<SpaceSetClaim> proven_in_space(const CommandLine& line,
                                           const SpaceClaimOptions& options, const Mesh& mesh,
                                           const std::vector<std::string>& names,
                                           const std::vector<files::PointsOfFile>& files);

}  // namespace lacuna::cli
