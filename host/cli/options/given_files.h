// The files that a command was given. No output may overwrite an input or another output.
#pragma once

#include <string>
#include <vector>

#include "cli/reports/output.h"

namespace lacuna::cli {

struct GivenFile {
    std::string name;  // of the argument, such as IMAGE, or of the option, with its dashes
    std::string path;  // "-" is standard input or output
};

std::vector<GivenFile> given_files(const std::vector<Output>& outputs);

// Throws BadRequest if two outputs, or an output and an input, are the same file after links are
// resolved; throws files::FileError if standard input would be read twice.
void check_given_files(const std::vector<GivenFile>& read, const std::vector<GivenFile>& written);

}  // namespace lacuna::cli
