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

#include "files/links.h"
#include "files/parse.h"
#include "files/point_files.h"

namespace lacuna::files {
namespace {

[[noreturn]] void fail_to_write(const std::string& path, int error) {
    throw FileError(path + ": " + std::generic_category().message(error));
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (errno == EPIPE)
            throw ClosedPipe(path + ": " + std::generic_category().message(EPIPE));
        else if (errno != EINTR)
            fail_to_write(path, errno);
    }
}

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }

    // Some file systems say only now that the disk is full.
    void close(const std::string& path) {
        if (::close(std::exchange(number_, -1)) != 0 && errno != EINTR) fail_to_write(path, errno);
    }

private:
    int number_;
};

// A file under a name of its own, which is gone at the end unless it was renamed.
class TemporaryFile {
public:
    // Beside `target`: a rename cannot cross file systems. Messages name `path`, which is what
    // the user called it.
    TemporaryFile(const std::filesystem::path& target, const std::string& path)
        : name_(name_beside(target)),
          path_(path),
          descriptor_(::mkostemp(name_.data(), O_CLOEXEC)) {
        if (descriptor_.number() < 0) fail_to_write(path_, errno);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!renamed_) ::unlink(name_.c_str());
    }

    void write(std::string_view bytes, mode_t permissions) {
        write_all(descriptor_.number(), bytes, path_);
        // May fail: some file systems know no permissions, and the points matter more.
        static_cast<void>(::fchmod(descriptor_.number(), permissions));
        // Else a crash after the rename could leave an empty file in place of the older one.
        if (::fsync(descriptor_.number()) != 0) fail_to_write(path_, errno);
        descriptor_.close(path_);
    }

    void rename_to(const std::filesystem::path& target) {
        if (::rename(name_.c_str(), target.c_str()) != 0) fail_to_write(path_, errno);
        renamed_ = true;
    }

private:
    static std::string name_beside(const std::filesystem::path& target) {
        // Cut, because the longer name must fit into the system's 255 bytes too.
        constexpr std::size_t kMaximalLength = 200;
        const std::string name = target.filename().string().substr(0, kMaximalLength);
        return (target.parent_path() / ("." + name + ".XXXXXX")).string();
    }

    std::string name_;
    std::string path_;
    Descriptor descriptor_;
    bool renamed_ = false;
};

// What is at `path` behind all links, if anything is.
std::optional<struct stat> status_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) return status;
    if (errno != ENOENT) fail_to_write(path, errno);
    return std::nullopt;
}

// The permissions that a shell's `> file` would give.
mode_t permissions_of_a_new_file() {
    const mode_t mask = ::umask(S_IRWXG | S_IRWXO);
    ::umask(mask);
    return (S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH) & ~mask;
}

// Whether `path` is a link, such as /dev/stdout, to what standard output goes to.
bool links_to_standard_output(const std::string& path, const struct stat& status) {
    struct stat standard_output {};
    std::error_code error;
    return ::fstat(STDOUT_FILENO, &standard_output) == 0 &&
           standard_output.st_dev == status.st_dev && standard_output.st_ino == status.st_ino &&
           std::filesystem::is_symlink(path, error);
}

// A device or a pipe keeps what it is given: there is nothing to rename.
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
    // A rename would replace even a file that is write-protected.
    if (older && ::access(path.c_str(), W_OK) != 0) fail_to_write(path, errno);

    const std::filesystem::path target = behind_links(path);
    TemporaryFile file(target, path);
    file.write(bytes, older ? older->st_mode & 0777U : permissions_of_a_new_file());
    file.rename_to(target);
}

}  // namespace lacuna::files
