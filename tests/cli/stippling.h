// Runs of `lacuna stipple`.
#pragma once

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cli/expectations.h"
#include "cli/pictures.h"
#include "files/read_points.h"
#include "program.h"

namespace lacuna::tests {

using Names = std::vector<std::string>;

// Runs `lacuna stipple IMAGE ARGUMENTS... --quiet -o OUTPUT`, with --relax 0 unless the arguments
// have --relax: most tests are about the set before relaxing.
inline Outcome stipple(const std::string& image, Names arguments, const std::string& output) {
    if (std::find(arguments.begin(), arguments.end(), "--relax") == arguments.end())
        arguments.insert(arguments.end(), {"--relax", "0"});
    arguments.insert(arguments.begin(), {"stipple", image});
    arguments.insert(arguments.end(), {"--quiet", "-o", output});
    return run(arguments);
}

// The points that stipple() makes.
inline std::vector<Point> points_of(const std::string& image, Names arguments) {
    const Folder folder;
    const Outcome outcome = stipple(image, std::move(arguments), folder.path("a.npy"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.exit_code == 0 ? lacuna::files::read_points(folder.path("a.npy")).points
                                  : std::vector<Point>{};
}

}  // namespace lacuna::tests
