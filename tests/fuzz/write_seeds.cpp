// Writes small valid files of every kind for the fuzzers to start from, into a folder.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "files/point_files.h"
#include "pictures/pictures.h"

namespace {

using namespace lacuna;

void write_seeds(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "images");
    std::filesystem::create_directories(folder / "points");
    for (const auto& [name, bytes] : pictures::one_of_each())
        files::write_whole(folder / "images" / name, bytes);
    const std::vector<Point> points{{0.25, 0.5}, {1e-3, -2}};
    char number = 0;
    for (const files::Format& format : files::formats()) {
        const std::string path = folder / "points" / ("a" + std::string(format.extension));
        const char which = number++;  // the fuzzer's first byte: see read_points_fuzz.cpp
        if (format.decode != nullptr) files::write_whole(path, which + format.encode({points}));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: write_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        write_seeds(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_seeds: %s\n", error.what());
        return 1;
    }
}
