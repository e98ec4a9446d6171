// Where a command writes to and in which format, checked before the work starts: a typo must not
// cost a long run.
#pragma once

#include <string>
#include <vector>
#include "cli/app_fwd.h"

#include "files/point_files.h"

namespace lacuna::cli {

// What --output and --format say.
struct OutputOptions {
    std::vector<std::string> paths;
    std::string format;  // empty: each path's own
};

// Adds --output, which may be given several times, and --format. `options` must outlive the
// command.
void add_outputs(CLI::App& command, OutputOptions& options, const std::string& symbol,
                 const std::string& help);

struct Output {
    std::string path;  // "-" is standard output
    const files::Format& format;
};

// Each path's format, one of those with the extensions in `allowed`, with blanks between them: that
// of its extension, that of --format, or `usual` where a path that is no file, such as "-" or
// /dev/stdout, tells none. Standard output, if any, is the last: who reads it may not read on.
// Throws BadRequest, and files::FileError where no file of that name could be made.
std::vector<Output> outputs_of(const OutputOptions& options, const std::string& allowed,
                               const std::string& usual);

// Whether the path names no file of its own: standard output, a descriptor, a device, a pipe.
bool is_stream(const std::string& path);

// Whether it is "-" or another name of standard output.
bool is_standard_output(const std::string& path);
bool has_standard_output(const std::vector<Output>& outputs);

// Throws files::FileError where no file of that name could be made.
void check_writable(const std::string& path);

// What `option` names is "-" or a .json file. Throws as outputs_of does.
void check_json(const std::string& option, const std::string& path);

}  // namespace lacuna::cli
