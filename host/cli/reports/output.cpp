// Checks paths and formats before the work starts, and writes files, then streams.
#include "cli/reports/output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/number_text.h"
#include "cli/terminal/run_program.h"
#include "files/links.h"

namespace lacuna::cli {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error);
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw files::FileError(fmt::format("{}: {}", path, why));
}

bool is_among(const files::Format* format, const std::string& allowed) {
    return format != nullptr &&
           (allowed + " ").find(fmt::format("{} ", format->extension)) != std::string::npos;
}

const files::Format& format_of(const std::string& path, const std::string& wanted,
                               const std::string& allowed, const std::string& usual) {
    const files::Format* const own = is_stream(path) ? nullptr : files::find_format_of(path);
    if (!wanted.empty()) {
        const files::Format* const format = files::find_format(wanted);
        if (!is_among(format, allowed))
            throw BadRequest("format", shown(wanted), "must be one of " + allowed);
        if (is_among(own, allowed) && own != format)
            throw BadRequest("format", shown(wanted),
                             "is not what the name of --output " + shown(path) + " says");
        return *format;
    }
    if (is_among(own, allowed)) return *own;
    if (is_stream(path)) return *files::find_format(usual);
    throw BadRequest("output", shown(path),
                     "the extension must be one of " + allowed + ", or --format must be given");
}

}  // namespace

std::vector<Output> outputs_of(const OutputOptions& options, const std::string& allowed,
                               const std::string& usual) {
    std::vector<Output> outputs;
    for (const std::string& path : options.paths) {
        outputs.push_back({path, format_of(path, options.format, allowed, usual)});
        check_writable(path);
    }
    std::vector<Output> in_order;
    for (const bool is_last : {false, true})
        for (const Output& output : outputs)
            if (is_standard_output(output.path) == is_last) in_order.push_back(output);
    return in_order;
}

bool are_pictures(const std::vector<Output>& outputs) {
    return std::all_of(outputs.begin(), outputs.end(),
                       [](const Output& output) { return output.format.medium.has_value(); });
}

std::string loss_of_columns(const std::vector<Output>& outputs) {
    for (const Output& output : outputs)
        if (!output.format.has_columns)
            return fmt::format("has no place in {}: give --output FILE with one of {}, or --format",
                               is_standard_output(output.path)
                                   ? "standard output as " + std::string(output.format.extension)
                                   : shown(output.path),
                               files::column_extensions());
    return "";
}

std::string with_name(std::string path, std::string_view place, const std::string& name) {
    std::size_t at = 0;
    while ((at = path.find(place, at)) != std::string::npos) {
        path.replace(at, place.size(), name);
        at += name.size();
    }
    return path;
}

void refuse_place(const std::vector<std::string>& paths, std::string_view place,
                  const std::string& option, const std::string& of) {
    for (const std::string& path : paths)
        if (path.find(place) != std::string::npos)
            throw BadRequest(of, shown(path),
                             fmt::format("{} in its name needs {}", place, option));
}

bool is_stream(const std::string& path) {
    if (path == "-" || files::descriptor_named(path)) return true;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool is_standard_output(const std::string& path) {
    return path == "-" || files::descriptor_named(path) == STDOUT_FILENO;
}

void print_last(const std::string& line) {
    std::fputs((printable(line) + "\n").c_str(), stderr);
}

void sum_up(const Written& written, const std::string& what, bool is_empty) {
    if (written.is_quiet || (written.is_on_screen() && !is_empty)) return;
    print_last(what + " -> " + paths_of(written.outputs));
}

std::string paths_of(const std::vector<Output>& outputs) {
    std::string paths;
    for (const Output& output : outputs) paths += (paths.empty() ? "" : ", ") + output.path;
    return paths;
}

bool has_standard_output(const std::vector<Output>& outputs) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [](const Output& output) { return is_standard_output(output.path); });
}

// Checks what files::write_whole will do: a regular file is written to a temporary file in the same
// folder, which is renamed; a device or a pipe is written directly.
void check_writable(const std::string& path) {
    if (is_standard_output(path)) return;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) refuse(path, reason(EISDIR));
    if (fs::exists(status) && access(path.c_str(), W_OK) != 0) refuse(path, reason(errno));
    if (fs::exists(status) && is_stream(path)) return;
    if (files::descriptor_named(path)) refuse(path, reason(EBADF));

    const fs::path folder = folder_of(files::behind_links(path));
    if (!fs::is_directory(folder, error))
        refuse(path, fmt::format("there is no folder {}", folder.string()));
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        refuse(path, fmt::format("cannot make a file in {}: {}", folder.string(), reason(errno)));
}

void check_json(const std::string& option, const std::string& path) {
    if (!is_stream(path) && fs::path(path).extension() != ".json")
        throw BadRequest(option, shown(path), "must be - or a file whose name ends in .json");
    check_writable(path);
}

void Writing::add(const std::string& path, std::function<std::string()> content) {
    (is_stream(path) ? streams_ : files_).push_back({path, std::move(content)});
}

void Writing::write() const {
    Interruption::finish_files_first();
    for (const File& file : files_) files::write_whole(file.path, file.content());
    Interruption::exit_at_once();
    for (const File& stream : streams_) files::write_whole(stream.path, stream.content());
}

}  // namespace lacuna::cli
