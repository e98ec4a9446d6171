// The files that a command was given: no output may overwrite an input or another output.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/reports/output.h"

namespace lacuna::cli {

// A file that the user has named.
struct GivenFile {
    std::string name;       // its argument, such as IMAGE, or its option with the dashes
    std::string path;       // "-" is standard input or output
    std::string note = {};  // what messages add to the path, such as the seed of the file's set
};

std::vector<GivenFile> given_files(const std::vector<Output>& outputs);

// The files that a command writes. at() gives one at a time, because --seeds can name millions.
struct WrittenFiles {
    std::size_t count;
    std::function<GivenFile(std::size_t index)> at;
};

// Follows links. Throws BadRequest if two outputs are the same file, or if an output is also read,
// and files::FileError if standard input would be read twice. The time is linear in the number of
// files written.
void check_given_files(const std::vector<GivenFile>& read, const WrittenFiles& written);
void check_given_files(const std::vector<GivenFile>& read, const std::vector<GivenFile>& written);

}  // namespace lacuna::cli
