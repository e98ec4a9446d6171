// A file's descriptor, and writing to it.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <utility>

#include "files/point_files.h"

namespace lacuna::files {

[[noreturn]] void fail_to_write(const std::string& path, int error);

// Throws FileError and ClosedPipe, which name `path`.
void write_all(int descriptor, std::string_view bytes, const std::string& path);

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }

    // Some file systems report a full disk only here, when the file is closed.
    void close(const std::string& path) {
        if (::close(std::exchange(number_, -1)) != 0 && errno != EINTR) fail_to_write(path, errno);
    }

private:
    int number_;
};

}  // namespace lacuna::files
