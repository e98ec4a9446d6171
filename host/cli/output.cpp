// Checks paths before the work starts.
#include "cli/output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "cli/options.h"

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

// As files::write_whole will find it: a new file is made beside the older one and renamed, but a
// device or a pipe is written into.
void check_writable(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) refuse(path, reason(EISDIR));
    if (fs::exists(status) && access(path.c_str(), W_OK) != 0) refuse(path, reason(errno));
    if (fs::exists(status) && !fs::is_regular_file(status)) return;

    const fs::path folder = folder_of(fs::weakly_canonical(path, error));
    if (error) refuse(path, error.message());
    if (!fs::is_directory(folder, error))
        refuse(path, fmt::format("there is no folder {}", folder.string()));
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        refuse(path, fmt::format("cannot make a file in {}: {}", folder.string(), reason(errno)));
}

}  // namespace

void check_output(const std::string& path) {
    files::format_of(path);
    if (path != "-") check_writable(path);
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    return fs::path(a).filename() == fs::path(b).filename() &&
           fs::equivalent(folder_of(a), folder_of(b), error) && !error;
}

const files::Format& format_among(const std::string& path, const std::string& allowed) {
    std::string extension = path == "-" ? "" : fs::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), files::lower_case);
    if (extension.empty() || (allowed + " ").find(extension + " ") == std::string::npos)
        throw BadRequest("output", shown(path), "the extension must be one of " + allowed);
    return files::format_of(path);
}

void check_json(const std::string& option, const std::string& path, const std::string& output) {
    if (fs::path(path).extension() != ".json")
        throw BadRequest(option, shown(path), "must be a file whose name ends in .json");
    check_writable(path);
    if (!output.empty() && is_same_file(path, output))
        throw BadRequest(option, shown(path), "must be another file than --output " + output);
}

}  // namespace lacuna::cli
