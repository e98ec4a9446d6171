// README's commands do what it says: each ends well, makes its files and warns of nothing, and a
// stippled picture has the ink of the photograph.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "pictures/image.h"
#include "program.h"

namespace {

using namespace lacuna::tests;
using lacuna::pictures::Image;

const std::string kRoot = LACUNA_EXAMPLES "/../";

// The program's commands among the indented lines of a page, without comments. A line that ends in
// a backslash is joined with the next one.
Words commands_in(const std::string& page, const std::string& program) {
    std::istringstream text(content_of(page));
    Words commands;
    bool goes_on = false;
    for (std::string line; std::getline(text, line);) {
        const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
        const bool begins = begin == 4 && line.substr(begin).starts_with(program);
        if (begins && !goes_on) commands.emplace_back();
        if (!begins && !goes_on) continue;
        // A comment begins with # or, on some pages, behind blanks.
        line = line.substr(begin);
        line = line.substr(0, std::min(line.find(" #"), line.find("    ")));
        goes_on = line.ends_with("\\");
        if (goes_on) line.pop_back();
        commands.back() += line;
    }
    return commands;
}

Words words_of(const std::string& command) {
    std::istringstream text(command);
    Words words;
    for (std::string word; text >> word;) words.push_back(word);
    return words;
}

Words outputs_of(const std::string& command) {
    const Words words = words_of(command);
    Words outputs;
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        if (words[i] == "-o") outputs.push_back(words[i + 1]);
    return outputs;
}

// The mean darkness of the smallest rectangle that holds all ink, so without margins.
double ink_of(const Image& image) {
    std::size_t left = image.columns, right = 0, top = image.rows, bottom = 0;
    double ink = 0;
    for (std::size_t row = 0; row < image.rows; ++row)
        for (std::size_t column = 0; column < image.columns; ++column) {
            const double dark = 1 - image.luminance[row * image.columns + column];
            if (dark == 0) continue;
            ink += dark;
            left = std::min(left, column);
            right = std::max(right, column + 1);
            top = std::min(top, row);
            bottom = std::max(bottom, row + 1);
        }
    return ink / static_cast<double>((right - left) * (bottom - top));
}

TEST(Readme, HasCommandsThatAllEndWellAndMakeTheirFiles) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("build"));
    std::filesystem::create_symlink(LACUNA_PROGRAM, folder.path("build/lacuna"));
    std::filesystem::create_directory_symlink(LACUNA_EXAMPLES, folder.path("examples"));
    const double wanted = ink_of(lacuna::pictures::read_image(LACUNA_EXAMPLES "/raccoon.png"));
    std::size_t stippled = 0;
    const Words commands = commands_in(kRoot + "README.md", "build/lacuna ");
    EXPECT_GT(commands.size(), 10U);
    for (const std::string& command : commands) {
        const Outcome outcome = run_in(folder, command);
        EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
        EXPECT_EQ(outcome.err.find("lacuna: "), std::string::npos) << command << "\n"
                                                                   << outcome.err;
        for (const std::string& output : outputs_of(command))
            EXPECT_GT(std::filesystem::file_size(folder.path(output)), 1000U) << command;
        if (words_of(command)[1] != "stipple" || command.find("--inks") != std::string::npos)
            continue;
        ++stippled;
        ASSERT_EQ(run_in(folder, command + " -o ink.png").exit_code, 0) << command;
        const double ink = ink_of(lacuna::pictures::read_image(folder.path("ink.png")));
        EXPECT_NEAR(ink / wanted, 1, 0.25) << command;  // an hour of a plotter has less
    }
    EXPECT_GT(stippled, 3U);
}

}  // namespace
