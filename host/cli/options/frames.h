// --frames: the pictures of a sequence, or the tiles of a film, and a file for each.
#pragma once

#include <string>
#include <vector>

namespace lacuna::cli {

// Throws BadRequest for --frames VALUE if there is no output, or if one has no {frame} in its name.
// `example` is such a name, and `each` says what each file has, as in "a file a picture".
void check_names_of_frames(const std::string& value, const std::vector<std::string>& outputs,
                           const char* example, const char* each);
// Throws BadRequest if an output has {frame} in its name, without --frames.
void refuse_frame_in(const std::vector<std::string>& outputs);
// The path with the frame's name in place of {frame}.
std::string path_of_frame(const std::string& path, const std::string& name);

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
