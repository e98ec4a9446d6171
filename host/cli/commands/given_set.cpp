// Reads points, their picture and their domain.
#include "cli/commands/given_set.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <utility>

#include "cli/options/options.h"
#include "files/read_sets.h"

namespace lacuna::cli {
namespace {

files::SetsOfFile read_one_set(const std::string& path) {
    files::SetsOfFile file = files::read_sets(path);
    if (file.sets.size() != 1)
        throw files::FileError(fmt::format("{}: has {} sets: must have one",
                                           path == "-" ? "standard input" : path,
                                           file.sets.size()));
    return file;
}

}  // namespace

void add_given_set(CLI::App& command, GivenSet& set, Request& request) {
    command.add_option("POINTS", set.points, "The points; - is standard input, as .txt")
        ->type_name("")
        ->required();
    command.add_option("IMAGE", set.picture.path, "The picture; - is standard input")
        ->type_name("");
    command
        .add_option_function<std::string>(
            "--domain",
            [&set, &request](const std::string& text) {
                read_domain("domain", text, request.width, request.height);
                set.has_domain = true;
            },
            "Width and height of the domain")
        ->type_name("WxH");
    command
        .add_flag_callback(
            "--torus", [&request] { request.boundary = Boundary::torus; }, "The edges wrap")
        ->disable_flag_override();
}

std::vector<GivenFile> files_of(const GivenSet& set) {
    std::vector<GivenFile> files{{"POINTS", set.points}};
    if (!set.picture.path.empty()) files.push_back({"IMAGE", set.picture.path});
    return files;
}

SetAndField read_given_set(const GivenSet& set, Request& request) {
    files::SetsOfFile file = read_one_set(set.points);
    SetAndField read{std::move(file.sets.front()), {}};
    if (!set.picture.path.empty()) {
        Request shape;
        read.field = read_field(set.picture, shape);
        if (!set.has_domain) {
            request.width = shape.width;
            request.height = shape.height;
        }
    }
    if (!set.has_domain && file.width) {
        request.width = *file.width;
        request.height = *file.height;
    }
    if (file.boundary == Boundary::torus) request.boundary = Boundary::torus;
    return read;
}

}  // namespace lacuna::cli
