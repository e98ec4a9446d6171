// What is checked of the paths to write before the work starts: a typo must not cost a long run.
#pragma once

#include <string>

#include "files/point_files.h"

namespace lacuna::cli {

// The path may be "-", standard output. Throws BadRequest for an unknown extension and
// files::FileError where no file of that name could be made.
void check_output(const std::string& path);

// The format of an output that may only have the extensions in `allowed`, with blanks between them
// as the message shows them. Throws BadRequest for any other.
const files::Format& format_among(const std::string& path, const std::string& allowed);

// Whether both paths lead to one file, there already or to be made.
bool is_same_file(const std::string& a, const std::string& b);

// What `option` names is a .json file other than the output, if there is one. Throws as
// check_output does.
void check_json(const std::string& option, const std::string& path, const std::string& output);

}  // namespace lacuna::cli
