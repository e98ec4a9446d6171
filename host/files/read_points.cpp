// The bytes of a point file, and which reader they are for.
#include "files/read_points.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "files/read_points_formats.h"

namespace lacuna::files {
namespace {

[[noreturn]] void fail(const std::string& name, int error) {
    refuse(name, std::generic_category().message(error));
}

// Until its end, which a pipe does not tell beforehand.
std::string read_all(int descriptor, const std::string& name) {
    constexpr std::size_t kFirstRoom = std::size_t{1} << 16U;
    struct stat status {};
    const bool has_size = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    std::string bytes(has_size ? static_cast<std::size_t>(status.st_size) + 1 : kFirstRoom, '\0');
    std::size_t size = 0;
    for (;;) {
        if (size == bytes.size()) bytes.resize(2 * size);
        const ssize_t got = ::read(descriptor, bytes.data() + size, bytes.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(name, errno);
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    bytes.resize(size);
    return bytes;
}

class OpenFile {
public:
    explicit OpenFile(const std::string& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC)) {
        if (descriptor_ < 0) fail(path, errno);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { ::close(descriptor_); }

    int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

Format format_to_read(const std::string& path) {
    try {
        return format_of(path);
    } catch (const BadRequest&) {
        refuse(path, "not a point file: the extension must be one of .txt .csv .npy .ply .json");
    }
}

void refuse_picture(Format format, const std::string& name) {
    if (format == Format::svg || format == Format::pdf || format == Format::png)
        refuse(name,
               "a picture, whose points are rounded to what can be seen: give the points as "
               ".txt .csv .npy .ply or .json");
}

}  // namespace

std::vector<Point> decode(std::string_view bytes, Format format, const std::string& name) {
    refuse_picture(format, name);
    switch (format) {
        case Format::csv:
            return decode_lines(bytes, true, name);
        case Format::npy:
            return decode_npy(bytes, name);
        case Format::ply:
            return decode_ply(bytes, name);
        case Format::json:
            return decode_json(bytes, name);
        default:
            return decode_lines(bytes, false, name);
    }
}

std::vector<Point> read_points(const std::string& path) {
    const Format format = format_to_read(path);
    refuse_picture(format, path);
    return decode(read_bytes(path), format, name_to_show(path));
}

std::string read_bytes(const std::string& path) {
    if (path == "-") return read_all(STDIN_FILENO, name_to_show(path));
    const OpenFile file(path);
    return read_all(file.descriptor(), path);
}

std::string name_to_show(const std::string& path) {
    return path == "-" ? "standard input" : path;
}

}  // namespace lacuna::files
