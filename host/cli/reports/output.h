// The outputs of a command and their formats, checked before the work starts, because a typo must
// not cost a long run; and their writing.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/terminal/interruption.h"
#include "files/point_files.h"

namespace lacuna::cli {

// The values of --output and --format.
struct OutputOptions {
    std::vector<std::string> paths;
    std::string format;  // empty: the extension of each path decides
};

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

// The path with `name` wherever it has `place`, such as {seed}.
std::string with_name(std::string path, std::string_view place, const std::string& name);

// Throws BadRequest if a path has `place` in its name, for which only `option` puts in something
// else, and the option was not given.
void refuse_place(const std::vector<std::string>& paths, std::string_view place,
                  const std::string& option, const std::string& of = "output");

// Whether the path is no regular file: standard output, a descriptor, a device or a pipe.
bool is_stream(const std::string& path);

// Whether the path is "-" or another name of standard output.
bool is_standard_output(const std::string& path);
bool has_standard_output(const std::vector<Output>& outputs);

// Whether all outputs are pictures, which have no columns.
bool are_pictures(const std::vector<Output>& outputs);

// Says why an output has no place for classes, inks and ellipses of points; empty if all have.
std::string loss_of_columns(const std::vector<Output>& outputs);

// The paths for a summary, with commas between them.
std::string paths_of(const std::vector<Output>& outputs);

// What a command was asked to write, and whether it says so at the end.
struct Written {
    const std::vector<Output>& outputs;
    const std::string& report;  // its path; may be empty
    bool is_quiet;

    // Whether standard output, which may be the terminal, has points or the report.
    bool is_on_screen() const { return has_standard_output(outputs) || is_standard_output(report); }
};
// The last line of a command on standard error: what was made, and the paths of the outputs.
// Nothing if it is quiet; nothing either if a set with points, or its report, is on the screen.
void sum_up(const Written& written, const std::string& what, bool is_empty = false);
// Prints the line.
void print_last(const std::string& line);

// Throws files::FileError if the file cannot be made or written.
void check_writable(const std::string& path);

// Checks that the path given with `option` is a stream or a .json file that can be written. Throws
// like outputs_of.
void check_json(const std::string& option, const std::string& path);

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
