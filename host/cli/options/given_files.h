// The files that a command was given: nothing that it reads or writes is overwritten by another.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/reports/output.h"

namespace lacuna::cli {

// What the user calls it: an argument such as IMAGE, or an option with its dashes.
struct GivenFile {
    std::string name;
    std::string path;       // "-" is standard input or output
    std::string note = {};  // what a message adds to the path, such as the seed that it is for
};

std::vector<GivenFile> given_files(const std::vector<Output>& outputs);

// The files that a command writes. They are told one at a time, because --seeds can name millions.
struct WrittenFiles {
    std::size_t count;
    std::function<GivenFile(std::size_t index)> at;
};

// Throws BadRequest where two of the files written are one, or one that is written is also read,
// links resolved; files::FileError where standard input would be read twice. The time is linear in
// the number of files written.
void check_given_files(const std::vector<GivenFile>& read, const WrittenFiles& written);
void check_given_files(const std::vector<GivenFile>& read, const std::vector<GivenFile>& written);

}  // namespace lacuna::cli
