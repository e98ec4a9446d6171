// What a command has made, on its way to files and standard output.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/terminal/interruption.h"

namespace lacuna::cli {

// Files are written first, all of them whatever signal comes. Then pipes, devices and standard
// output, in the order in which they were added: these may block for ever, so that a signal ends
// the program at once.
class Writing {
public:
    explicit Writing(Interruption&) {}  // one must live: without, a signal could leave half a file

    // `content` is called when it is the file's turn. "-" is standard output.
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
