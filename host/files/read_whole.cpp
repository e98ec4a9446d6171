// Reads a file, a pipe or standard input to its end.
#include "files/read_whole.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>

#include "base/polling.h"
#include "files/parse.h"
#include "plan/sizes.h"

namespace lacuna::files {
namespace {

[[noreturn]] void fail_to_read(const std::string& name, int error) {
    refuse(name, std::generic_category().message(error));
}

[[noreturn]] void refuse_more(const std::string& name, std::uint64_t most) {
    refuse(name,
           fmt::format("has more than {} bytes, which a file to be read may have at most", most));
}

// Reads until the end, because the size of a pipe is not known beforehand.
std::string read_all(int descriptor, const std::string& name, std::uint64_t most,
                     const LookAtFirst& look) {
    constexpr std::size_t kFirstRoom = std::size_t{1} << 16U;
    constexpr std::size_t kAtOnce = std::size_t{1} << 24U;
    struct stat status {};
    const bool has_size = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    if (has_size && static_cast<std::uint64_t>(status.st_size) > most) refuse_more(name, most);
    std::string bytes(has_size ? static_cast<std::size_t>(status.st_size) + 1 : kFirstRoom, '\0');
    std::size_t size = 0;
    for (;;) {
        if (size > most) refuse_more(name, most);
        if (size == bytes.size()) bytes.resize(std::min(2 * size, std::size_t{most} + 1));
        ask();
        const std::size_t room =
            size < kFirstRoom ? std::min(kFirstRoom, bytes.size()) : bytes.size();
        const ssize_t got = ::read(descriptor, bytes.data() + size, std::min(room - size, kAtOnce));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_to_read(name, errno);
        if (got == 0) break;
        const bool were_few = size < kFirstRoom;
        size += static_cast<std::size_t>(got);
        if (look && were_few && size >= kFirstRoom) look({bytes.data(), size});
    }
    bytes.resize(size);
    return bytes;
}

class OpenFile {
public:
    explicit OpenFile(const std::string& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC)) {
        if (descriptor_ < 0) fail_to_read(path, errno);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { ::close(descriptor_); }

    int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

}  // namespace

std::string name_of(const std::string& path) {
    return path == "-" ? "standard input" : path;
}

std::uint64_t most_bytes() {
    return machine_memory_bytes() / 4;
}

std::string read_whole(const std::string& path, std::uint64_t most, const LookAtFirst& look) {
    if (path == "-") return read_all(STDIN_FILENO, name_of(path), most, look);
    const OpenFile file(path);
    return read_all(file.descriptor(), path, most, look);
}

}  // namespace lacuna::files
