// README's commands do what it says: each ends well, makes its files and warns of nothing, and a
// stippled picture has the ink of the photograph. Those of all pages make the same sets in C.
#include <gtest/gtest.h>
#include <lacuna.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "files/read_points.h"
#include "pictures/image.h"
#include "program.h"
#include "recipes/options.h"

namespace {

using namespace lacuna;
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

// Whether lacuna.h has an option, which it has not if it is about files or drawings.
bool has_in_c(const std::string& options) {
    lacuna_free(lacuna_sample(options.c_str(), nullptr));
    return std::string(lacuna_error()).find("is for the command alone") == std::string::npos;
}

// The options of `lacuna sample` that decide the points of its set, as a text for lacuna.h. Empty
// if lacuna.h lacks one of them, and for commands that make several sets, read files or are others.
std::string text_for_c(const std::string& command) {
    const Words words = words_of(command);
    std::string text;
    for (std::size_t i = 2; i < words.size() && words[1] == "sample"; ++i) {
        if (words[i] == "|" || words[i] == ">") break;
        const std::size_t dashes = std::min(words[i].find_first_not_of('-'), words[i].size());
        const auto* const option = recipes::find_option(recipes::kSample, words[i].substr(dashes));
        if (option == nullptr) return "";
        std::string given = "--" + std::string(option->name);
        if (i + 1 < words.size() && !words[i + 1].starts_with("-")) given += " " + words[++i];
        if (option->name == "seeds" || option->names_a_file() || given == "--help") return "";
        if (has_in_c(given))
            text += " " + given;
        else if (option->traits.decides_points)
            return "";
    }
    return text;
}

TEST(CommandsOfThePages, MakeTheSameSetsInC) {
    Words commands = commands_in(kRoot + "README.md", "build/lacuna ");
    for (const auto& page : std::filesystem::directory_iterator(kRoot + "docs"))
        if (page.is_regular_file())
            commands = joined(commands, commands_in(page.path(), "lacuna "));
    const Folder folder;
    int compared = 0;
    for (const std::string& command : commands) {
        const std::string text = text_for_c(command);
        const bool is_large = text.find("--radius 0.000") != std::string::npos;
        if (text.empty() || is_large) continue;
        const std::string points = folder.path("a.csv");
        expect_success(joined({"sample", "--quiet", "-o", points}, words_of(text)));
        const std::unique_ptr<lacuna_set, void (*)(lacuna_set*)> set(
            lacuna_sample(text.c_str(), nullptr), lacuna_free);
        ASSERT_NE(set, nullptr) << text << ": " << lacuna_error();
        const std::vector<lacuna::Point> expected = lacuna::files::read_points(points);
        ASSERT_EQ(lacuna_count(set.get()), expected.size()) << command;
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(),
                               reinterpret_cast<const lacuna::Point*>(lacuna_points(set.get()))))
            << command;
        ++compared;
    }
    EXPECT_GE(compared, 12);
}

}  // namespace
