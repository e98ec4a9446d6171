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
// BadRequest if there is none, if there is no output, if one has no {frame} in its name, if two
// files have the same name but for folder and extension, if an output is one of these files or
// another output, or if the pictures have different proportions, and FileError if one is no
// picture.
std::vector<Frame> frames_of(const std::string& pattern, const std::vector<std::string>& outputs);

}  // namespace lacuna::cli
