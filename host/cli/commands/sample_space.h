// The run of `lacuna sample` on a mesh or in a volume, and what `lacuna verify` shares with it.
#pragma once

#include <lacuna/space.h>

#include <string>

#include "cli/options/common_options.h"
#include "options/space.h"

namespace lacuna::cli {

// Calls `work` and returns what it returns. A BadRequest of the mesh becomes a files::FileError
// with its name.
template <class Work>
auto naming_mesh(const options::InSpace& space, const Work& work) {
    try {
        return work();
    } catch (const BadRequest& error) {
        if (error.option() != "mesh") throw;
        throw files::FileError(space.mesh + ": " + error.what());
    }
}

// Makes the set and writes it. `keep` is the path of --keep, or empty.
void sample_in_space(const CommandLine& line, const CommonOptions& options,
                     const options::InSpace& space, const std::string& keep);

}  // namespace lacuna::cli
