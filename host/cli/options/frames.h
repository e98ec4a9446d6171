// --frames: the pictures of a sequence, and a file for each.
#pragma once

#include <string>
#include <vector>

namespace lacuna::cli {

struct Frame {
    std::string image;                 // its path
    std::vector<std::string> outputs;  // the paths of --output with its name in place of {frame}
};

// The files that match the pattern, as a shell matches them, in the order of their names. Throws
// BadRequest if there is none, if an output has no {frame} in its name, or if two files have the
// same name but for folder and extension.
std::vector<Frame> frames_of(const std::string& pattern, const std::vector<std::string>& outputs);

}  // namespace lacuna::cli
