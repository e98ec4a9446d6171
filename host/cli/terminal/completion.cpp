// Finds the words that may follow, and the word with the least edit distance.
#include "cli/terminal/completion.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "files/point_files.h"
#include "options/options.h"

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

std::string lines_of(std::span<const std::string_view> words) {
    std::string lines;
    for (const std::string_view word : words) lines += std::string(word) + "\n";
    return lines;
}

std::string lines_of_commands(const CLI::App& app) {
    std::string lines;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        const std::string about = command->get_description();
        lines += command->get_name() + "\t" + about.substr(0, about.find('\n')) + "\n";
    }
    return lines;
}

std::string lines_of_options(std::span<const options::Option* const> options) {
    std::string lines = "--help\tPrint the help message\n";
    for (const options::Option* option : options)
        if (!option->is_argument())
            lines += "--" + std::string(option->name) + "\t" +
                     std::string(options::help_of(*option)) + "\n";
    return lines;
}

// The row of the option that `word` names, with one or two dashes; null if it has no value.
const options::Option* option_with_value(options::Commands command, std::string_view word) {
    if (!word.starts_with("-")) return nullptr;
    const std::size_t dashes = std::min(word.find_first_not_of('-'), word.size());
    const options::Option* const option = options::find_option(command, word.substr(dashes));
    return option != nullptr && option->kind != options::Kind::flag ? option : nullptr;
}

}  // namespace

std::string words_at(const CLI::App& app, std::span<const std::string> typed) {
    if (typed.size() < 2 || typed.front() == "help") return lines_of_commands(app);
    const std::optional<options::Commands> command = options::command_called(typed.front());
    if (!command) return "";
    if (const auto* const before = option_with_value(*command, typed[typed.size() - 2]))
        return lines_of(options::words_of(before->traits.words));
    const std::vector<const options::Option*> options = options::options_of(*command);
    if (typed.back().starts_with("-")) return lines_of_options(options);
    for (const options::Option* option : options)
        if (option->is_argument()) return lines_of(options::words_of(option->traits.words));
    return "";
}

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
    // Options of which a word begins like this, such as --paper and --time.
    constexpr std::size_t kShortestBeginning = 5, kMostNames = 4;
    if (stem.size() < kShortestBeginning || !stem.starts_with("--")) return "";
    std::vector<std::string_view> longer;
    for (const std::string& name : known)
        if (name.find(stem.substr(1)) != std::string::npos) longer.push_back(name);
    if (longer.empty() || longer.size() > kMostNames) return "";
    return ", did you mean " + options::listed(longer) + "?";
}

}  // namespace lacuna::cli
