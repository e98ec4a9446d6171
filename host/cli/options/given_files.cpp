// Tells whether two paths lead to one file.
#include "cli/options/given_files.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <unordered_map>

#include "base/number_text.h"
#include "files/links.h"
#include "files/point_files.h"

namespace lacuna::cli {
namespace {

// What a path leads to: a file or, if it does not exist, the folder and the file's name in it.
struct FilePlace {
    std::optional<int> descriptor;  // that the path names
    struct stat status {};
    std::string new_name;  // empty if the file exists

    bool is_regular() const { return !new_name.empty() || S_ISREG(status.st_mode); }
    // /dev/null drops what is written to it, so it may be named twice.
    bool is_null() const {
        return new_name.empty() && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
    }
};

bool lead_to_one(const FilePlace& a, const FilePlace& b) {
    return a.status.st_dev == b.status.st_dev && a.status.st_ino == b.status.st_ino &&
           a.new_name == b.new_name;
}

std::size_t hash_of(const FilePlace& place) {
    return std::hash<std::string>{}(
        fmt::format("{} {} {}", place.status.st_dev, place.status.st_ino, place.new_name));
}

// Unset if the system cannot find it. Reading or writing the file will then fail with the reason.
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

// Writes to two descriptors of one file follow each other. One descriptor twice would mix contents.
bool overwrite_each_other(const FilePlace& a, const FilePlace& b) {
    if (a.descriptor && b.descriptor) return a.descriptor == b.descriptor;
    const bool renames = !a.descriptor && !b.descriptor;
    return lead_to_one(a, b) && (renames || a.is_regular());
}

[[noreturn]] void refuse_same(const GivenFile& file, const GivenFile& other) {
    throw BadRequest(
        file.name.substr(2), shown(file.path) + file.note,
        "must be another file than " + other.name + " " + shown(other.path) + other.note);
}

}  // namespace

std::vector<GivenFile> given_files(const std::vector<Output>& outputs) {
    std::vector<GivenFile> files;
    files.reserve(outputs.size());
    for (const Output& output : outputs) files.push_back({"--output", output.path});
    return files;
}

void check_given_files(const std::vector<GivenFile>& read, const WrittenFiles& written) {
    const auto is_standard = [](const GivenFile& file) { return file.path == "-"; };
    if (std::count_if(read.begin(), read.end(), is_standard) > 1)
        throw files::FileError("standard input: can be read only once");
    std::vector<std::optional<FilePlace>> inputs;
    inputs.reserve(read.size());
    for (const GivenFile& input : read) inputs.push_back(file_place_of(input.path, STDIN_FILENO));
    // Hashes take less memory than FilePlace objects. If two are equal, the files are compared.
    std::unordered_multimap<std::size_t, std::size_t> index_of_hash;
    for (std::size_t i = 0; i < written.count; ++i) {
        const GivenFile file = written.at(i);
        const std::optional<FilePlace> place = file_place_of(file.path, STDOUT_FILENO);
        if (!place || place->is_null()) continue;
        const auto [begin, end] = index_of_hash.equal_range(hash_of(*place));
        for (auto earlier = begin; earlier != end; ++earlier) {
            const GivenFile other = written.at(earlier->second);
            const auto other_place = file_place_of(other.path, STDOUT_FILENO);
            if (other_place && overwrite_each_other(*place, *other_place)) refuse_same(file, other);
        }
        for (std::size_t k = 0; k < read.size(); ++k)
            if (inputs[k] && place->is_regular() && lead_to_one(*place, *inputs[k]))
                refuse_same(file, read[k]);
        index_of_hash.emplace(hash_of(*place), i);
    }
}

void check_given_files(const std::vector<GivenFile>& read, const std::vector<GivenFile>& written) {
    check_given_files(read, {written.size(), [&](std::size_t index) { return written[index]; }});
}

}  // namespace lacuna::cli
