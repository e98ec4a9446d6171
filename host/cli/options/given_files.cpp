// Finds out whether two paths lead to the same file.
#include "cli/options/given_files.h"

#include <lacuna/lacuna.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/options/options.h"
#include "files/links.h"
#include "files/point_files.h"

namespace lacuna::cli {
namespace {

// Identifies a file. If it does not exist yet, its folder and its name in the folder identify it.
struct FilePlace {
    std::optional<int> descriptor;  // set if the path names a descriptor
    struct stat status {};          // of the file, or of its folder
    std::string new_name;           // empty if the file exists

    bool is_regular() const { return !new_name.empty() || S_ISREG(status.st_mode); }
    // /dev/null may be given twice: whatever is written to it is lost anyway.
    bool is_null() const {
        return new_name.empty() && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
    }
};

bool lead_to_one(const FilePlace& a, const FilePlace& b) {
    return a.status.st_dev == b.status.st_dev && a.status.st_ino == b.status.st_ino &&
           a.new_name == b.new_name;
}

// Unset if the system does not say. Reading or writing the file will then fail with the reason.
std::optional<FilePlace> file_place_of(const std::string& path, int standard) {
    FilePlace place;
    place.descriptor = path == "-" ? standard : files::descriptor_named(path);
    if (path == "/dev/stdin") place.descriptor = STDIN_FILENO;
    if (place.descriptor)
        return fstat(*place.descriptor, &place.status) == 0 ? std::optional(place) : std::nullopt;
    if (stat(path.c_str(), &place.status) == 0) return place;
    const std::filesystem::path target = files::behind_links(path);
    const std::string folder = target.has_parent_path() ? target.parent_path().string() : ".";
    place.new_name = target.filename().string();
    return stat(folder.c_str(), &place.status) == 0 ? std::optional(place) : std::nullopt;
}

// Two different descriptors of one file append to it, which is allowed. One descriptor given twice
// would mix two contents.
bool overwrite_each_other(const FilePlace& a, const FilePlace& b) {
    if (a.is_null()) return false;
    if (a.descriptor && b.descriptor) return a.descriptor == b.descriptor;
    const bool renames = !a.descriptor && !b.descriptor;
    return lead_to_one(a, b) && (renames || a.is_regular());
}

[[noreturn]] void refuse_same(const GivenFile& file, const GivenFile& other) {
    throw BadRequest(file.name.substr(2), shown(file.path),
                     "must be another file than " + other.name + " " + shown(other.path));
}

}  // namespace

std::vector<GivenFile> given_files(const std::vector<Output>& outputs) {
    std::vector<GivenFile> files;
    files.reserve(outputs.size());
    for (const Output& output : outputs) files.push_back({"--output", output.path});
    return files;
}

void check_given_files(const std::vector<GivenFile>& read, const std::vector<GivenFile>& written) {
    const auto is_standard = [](const GivenFile& file) { return file.path == "-"; };
    if (std::count_if(read.begin(), read.end(), is_standard) > 1)
        throw files::FileError("standard input: can be read only once");
    for (std::size_t i = 0; i < written.size(); ++i) {
        const std::optional<FilePlace> place = file_place_of(written[i].path, STDOUT_FILENO);
        if (!place) continue;
        for (std::size_t k = 0; k < i; ++k) {
            const auto other = file_place_of(written[k].path, STDOUT_FILENO);
            if (other && overwrite_each_other(*place, *other)) refuse_same(written[i], written[k]);
        }
        for (const GivenFile& input : read) {
            const auto other = file_place_of(input.path, STDIN_FILENO);
            if (other && place->is_regular() && lead_to_one(*place, *other))
                refuse_same(written[i], input);
        }
    }
}

}  // namespace lacuna::cli
