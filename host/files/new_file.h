// A file that appears whole or not at all.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

#include "files/descriptor.h"

namespace lacuna::files {

// What is at `path` behind all links, if anything is. Throws FileError.
std::optional<struct stat> status_of(const std::string& path);

// Lies beside the file that it is to replace, for a rename cannot cross file systems, under a name
// of its own, and is gone at the end unless it was put in place. Messages name `path`, which is
// what the user called it. Throws FileError.
class NewFile {
public:
    // Refuses a path where there is a file that cannot be written.
    explicit NewFile(const std::string& path);
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    const std::string& name() const { return name_; }
    int descriptor() const { return descriptor_.number(); }

    // Puts it, as it is on the disk, in place of what was there, whose permissions it takes over.
    void put_in_place();

private:
    std::string path_;
    mode_t permissions_;
    std::filesystem::path target_;
    std::string name_;
    Descriptor descriptor_;
    bool is_in_place_ = false;
};

}  // namespace lacuna::files
