// Tells whether two paths lead to one file.
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

// What a path leads to: a file or, where it is not there yet, its folder and its name in it.
struct FilePlace {
    std::optional<int> descriptor;  // that the path names
    struct stat status {};
    std::string new_name;  // empty where the file is there

    bool is_regular() const { return !new_name.empty() || S_ISREG(status.st_mode); }
    // What is written there is gone: it may be named twice.
    bool is_null() const {
        return new_name.empty() && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
    }
};

bool lead_to_one(const FilePlace& a, const FilePlace& b) {
    return a.status.st_dev == b.status.st_dev && a.status.st_ino == b.status.st_ino &&
           a.new_name == b.new_name;
}

// Nothing where it cannot be told: whoever reads or writes it will say why.
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

// Two descriptors of one file add to it in turn; the same one twice mixes up two contents.
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
