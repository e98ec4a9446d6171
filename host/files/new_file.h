// A file that appears whole or not at all.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

#include "files/descriptor.h"

namespace lacuna::files {

// The status of the file to which `path` leads through all links, if it exists. Throws FileError.
std::optional<struct stat> status_of(const std::string& path);

// A file with a temporary name that can replace the file at `path`. It lies in the same directory,
// because a rename cannot cross file systems. The destructor deletes it unless it was put in place.
// Messages name `path`. Throws FileError.
class NewFile {
public:
    // Throws FileError if a file exists at `path` and is write-protected.
    explicit NewFile(const std::string& path);
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    const std::string& name() const { return name_; }
    int descriptor() const { return descriptor_.number(); }

    // Flushes the bytes to the disk, then replaces the older file and takes over its permissions.
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
