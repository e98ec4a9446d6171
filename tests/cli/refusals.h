// Tables of command lines that are refused.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/expectations.h"
#include "cli/pictures.h"
#include "cli/program.h"

namespace lacuna::tests {

struct Refusal {
    std::string arguments;  // as typed in a shell: quotes and < are its own
    int exit_code;
    std::array<std::string, 4> told;  // what the line on standard error holds
};

using Refusals = std::vector<Refusal>;
using Files = std::map<std::string, std::string>;  // name and content

inline Files files_in(const std::string& folder) {
    Files files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        files[entry.path()] = entry.is_regular_file() ? content_of(entry.path()) : "";
    return files;
}

// In `folder`, each command `lacuna BEGINNING ARGUMENTS` prints one error and writes no file.
inline void expect_refusals(const Folder& folder, const std::string& beginning,
                            const Refusals& refusals) {
    Setting shell;
    shell.program = "/bin/sh";
    const Files before = files_in(folder.path("."));
    for (const auto& [arguments, exit_code, told] : refusals) {
        const std::string command = beginning + " " + arguments;
        SCOPED_TRACE("lacuna " + command);
        const std::string line =
            "cd " + folder.path(".") + " && exec " LACUNA_PROGRAM " " + command;
        expect_one_error(run({"-c", line}, shell), exit_code, {told.begin(), told.end()});
        EXPECT_TRUE(files_in(folder.path(".")) == before) << "a file was written or changed";
    }
}

// The same in a folder with these files and raccoon.png.
inline void expect_refusals(const Files& files, const std::string& beginning,
                            const Refusals& refusals) {
    const Folder folder;
    for (const auto& [name, content] : files) {
        const std::filesystem::path path = folder.path(name);
        std::filesystem::create_directories(path.parent_path());
        write_file(path, content);
    }
    std::filesystem::create_symlink(kRaccoon, folder.path("raccoon.png"));
    expect_refusals(folder, beginning, refusals);
}

}  // namespace lacuna::tests
