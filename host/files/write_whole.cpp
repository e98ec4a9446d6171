// Writes a file whole or not at all: into a new file beside it, then a rename.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "files/descriptor.h"
#include "files/new_file.h"
#include "files/parse.h"
#include "files/point_files.h"

namespace lacuna::files {
namespace {

// Whether `path` is a link, such as /dev/stdout, to the file that standard output is written to.
bool links_to_standard_output(const std::string& path, const struct stat& status) {
    struct stat standard_output {};
    std::error_code error;
    return ::fstat(STDOUT_FILENO, &standard_output) == 0 &&
           standard_output.st_dev == status.st_dev && standard_output.st_ino == status.st_ino &&
           std::filesystem::is_symlink(path, error);
}

// A device or a pipe cannot be replaced by a rename, so the bytes are written to it directly.
void write_into(const std::string& path, std::string_view bytes) {
    Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
    if (descriptor.number() < 0) fail_to_write(path, errno);
    write_all(descriptor.number(), bytes, path);
    descriptor.close(path);
}

}  // namespace

std::optional<int> descriptor_named(const std::string& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder)) continue;
        std::string_view number = std::string_view(path).substr(folder.size());
        int descriptor = 0;
        if (take_number(number, descriptor) == std::errc{} && number.empty() && descriptor >= 0)
            return descriptor;
    }
    return std::nullopt;
}

void write_whole(const std::string& path, std::string_view bytes) {
    if (path == "-") return write_all(STDOUT_FILENO, bytes, "standard output");
    if (const auto descriptor = descriptor_named(path)) return write_all(*descriptor, bytes, path);
    const std::optional<struct stat> older = status_of(path);
    if (older && S_ISDIR(older->st_mode)) fail_to_write(path, EISDIR);
    if (older && links_to_standard_output(path, *older))
        return write_all(STDOUT_FILENO, bytes, path);
    if (older && !S_ISREG(older->st_mode)) return write_into(path, bytes);
    NewFile file(path);
    write_all(file.descriptor(), bytes, path);
    file.put_in_place();
}

}  // namespace lacuna::files
