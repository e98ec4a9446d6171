// The outputs of a command and their formats, checked before the work starts: a typo must not cost
// a long run.
#pragma once

#include <string>
#include <vector>
#include "cli/app_fwd.h"

#include "files/point_files.h"

namespace lacuna::cli {

// The values of --output and --format.
struct OutputOptions {
    std::vector<std::string> paths;
    std::string format;  // empty: the extension of each path decides
};

// Adds --output, which may be given several times, and --format. `options` must outlive the
// command.
void add_outputs(CLI::App& command, OutputOptions& options, const std::string& symbol,
                 const std::string& help);

struct Output {
    std::string path;  // "-" is standard output
    const files::Format& format;
};

// The outputs with their formats. `allowed` lists extensions with blanks between them. The path's
// extension or --format gives the format. Without either, `usual` is the format of paths that are
// no regular file, such as "-" or /dev/stdout. Standard output, if any, comes last: its reader may
// stop reading. Throws BadRequest, and files::FileError if a file cannot be made.
std::vector<Output> outputs_of(const OutputOptions& options, const std::string& allowed,
                               const std::string& usual);

// Whether the path is no regular file: standard output, a descriptor, a device or a pipe.
bool is_stream(const std::string& path);

// Whether the path is "-" or another name of standard output.
bool is_standard_output(const std::string& path);
bool has_standard_output(const std::vector<Output>& outputs);

// Says why an output has no place for classes, inks and ellipses of points; empty if all have.
std::string loss_of_columns(const std::vector<Output>& outputs);

// The paths for a summary, with commas between them.
std::string paths_of(const std::vector<Output>& outputs);

// Throws files::FileError if the file cannot be made or written.
void check_writable(const std::string& path);

// Checks that the path given with `option` is a stream or a .json file that can be written. Throws
// like outputs_of.
void check_json(const std::string& option, const std::string& path);

}  // namespace lacuna::cli
