// The files that a command was given: nothing that it reads or writes is overwritten by another.
#pragma once

#include <string>
#include <vector>

#include "cli/reports/output.h"

namespace lacuna::cli {

// What the user calls it: an argument such as IMAGE, or an option with its dashes.
struct GivenFile {
    std::string name;
    std::string path;  // "-" is standard input or output
};

std::vector<GivenFile> given_files(const std::vector<Output>& outputs);

// Throws BadRequest where two of the files written are one, or one that is written is also read,
// links resolved; files::FileError where standard input would be read twice.
void check_given_files(const std::vector<GivenFile>& read, const std::vector<GivenFile>& written);

}  // namespace lacuna::cli
