// Finds the word with the least edit distance.
#include "cli/commands/nearest.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <cstddef>

#include "files/point_files.h"

namespace lacuna::cli {
namespace {

// The edit distance, with swaps of neighbouring letters (optimal string alignment).
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> steps(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                steps[i][j] = i + j;
                continue;
            }
            steps[i][j] = std::min({steps[i - 1][j] + 1, steps[i][j - 1] + 1,
                                    steps[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
        }
    return steps.back().back();
}

}  // namespace

std::vector<std::string> names_of_commands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> names_of_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::string nearest_text(const std::string& word, const std::vector<std::string>& known) {
    constexpr std::size_t kMostSteps = 2;
    constexpr std::size_t kLongestWord = 64;
    std::string stem = word.substr(0, word.find('='));
    if (stem.starts_with("--"))
        std::transform(stem.begin(), stem.end(), stem.begin(), files::lower_case);
    // For an unknown short option, such as -r, the first long option that begins with its letter.
    if (stem.size() == 2 && stem[0] == '-' && stem[1] != '-') {
        const auto same = std::find_if(known.begin(), known.end(), [&](const std::string& name) {
            return name.starts_with("-" + stem);
        });
        return same == known.end() ? "" : ", did you mean " + *same + "?";
    }
    if (stem.size() > kLongestWord) return "";
    const std::size_t most = std::min(kMostSteps, stem.size() / 3);
    const auto nearer = [&](const std::string& a, const std::string& b) {
        return distance(stem, a) < distance(stem, b);
    };
    const auto nearest = std::min_element(known.begin(), known.end(), nearer);
    if (nearest != known.end() && distance(stem, *nearest) <= most)
        return ", did you mean " + *nearest + "?";
    // The beginning of a longer option, such as --dot of --dot-size.
    constexpr std::size_t kShortestBeginning = 5;
    const auto longer = std::find_if(known.begin(), known.end(), [&](const std::string& name) {
        return stem.size() >= kShortestBeginning && name.starts_with(stem);
    });
    return longer == known.end() ? "" : ", did you mean " + *longer + "?";
}

}  // namespace lacuna::cli
