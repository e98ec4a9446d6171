// Writes the results of a command to files and standard output.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/terminal/interruption.h"

namespace lacuna::cli {

// Files are written first; a signal waits until all of them are finished. Then pipes, devices and
// standard output are written in the order in which they were added. These may block for ever, so a
// signal then ends the program at once.
class Writing {
public:
    // An Interruption must exist: without it a signal could leave half a file.
    explicit Writing(Interruption&) {}

    // `content` is called when the file is about to be written. "-" is standard output.
    void add(const std::string& path, std::function<std::string()> content);

    // Throws what files::write_whole throws.
    void write() const;

private:
    struct File {
        std::string path;
        std::function<std::string()> content;
    };
    std::vector<File> files_, streams_;
};

}  // namespace lacuna::cli
