// Writes a new file beside the older one, then renames it.
#include "files/new_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "base/polling.h"
#include "files/links.h"

namespace lacuna::files {
namespace {

std::string name_beside(const std::filesystem::path& target) {
    // Limit for the user's part of the name: with a dot and a suffix it must fit into 255 bytes.
    constexpr std::size_t kMaximalLength = 200;
    const std::string name = target.filename().string().substr(0, kMaximalLength);
    return (target.parent_path() / ("." + name + ".XXXXXX")).string();
}

// The permissions that a file gets from a shell's `> file`.
mode_t permissions_of_a_new_file() {
    const mode_t mask = ::umask(S_IRWXG | S_IRWXO);
    ::umask(mask);
    return (S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH) & ~mask;
}

mode_t permissions_for(const std::string& path) {
    const std::optional<struct stat> older = status_of(path);
    if (!older) return permissions_of_a_new_file();
    // Checked because a rename would replace even a file that is write-protected.
    if (::access(path.c_str(), W_OK) != 0) fail_to_write(path, errno);
    return older->st_mode & 0777U;
}

}  // namespace

void fail_to_write(const std::string& path, int error) {
    throw FileError(path + ": " + std::generic_category().message(error));
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
    constexpr std::size_t kAtOnce = std::size_t{1} << 24U;
    while (!bytes.empty()) {
        ask();
        const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), kAtOnce));
        if (written >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (errno == EPIPE)
            throw ClosedPipe(path + ": " + std::generic_category().message(EPIPE));
        else if (errno != EINTR)
            fail_to_write(path, errno);
    }
}

std::optional<struct stat> status_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) return status;
    if (errno != ENOENT) fail_to_write(path, errno);
    return std::nullopt;
}

NewFile::NewFile(const std::string& path)
    : path_(path),
      permissions_(permissions_for(path)),
      target_(behind_links(path)),
      name_(name_beside(target_)),
      descriptor_(::mkostemp(name_.data(), O_CLOEXEC)) {
    if (descriptor_.number() < 0) fail_to_write(path_, errno);
}

NewFile::~NewFile() {
    if (!is_in_place_) ::unlink(name_.c_str());
}

void NewFile::put_in_place() {
    // A failure is ignored: some file systems have no permissions, and the points matter more.
    static_cast<void>(::fchmod(descriptor_.number(), permissions_));
    // Without fsync a crash after the rename could leave an empty file instead of the older one.
    if (::fsync(descriptor_.number()) != 0) fail_to_write(path_, errno);
    descriptor_.close(path_);
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail_to_write(path_, errno);
    is_in_place_ = true;
}

}  // namespace lacuna::files
