// The options of `lacuna again`, and its run.
#include <fmt/core.h>
#include <lacuna/version.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "cli/commands/commands.h"
#include "cli/options/bind.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "files/read_whole.h"

namespace lacuna::cli {
namespace {

constexpr const char* kAgainDescription =
    R"(Makes a file again, byte for byte, by the command that it records.

Examples:
  lacuna again plot.svg -o again.svg                    from the picture where it lay
  lacuna again plot.svg photos/cat.jpg -o plot.pdf      from where it lies now, as another file

FILE is an .svg or .json that lacuna sample, stipple, relax or order has made. Files that the
command read are found from the folder in which lacuna is called. The picture of stipple must be the
one that it was: files record its SHA-256.

Exit code: 0 done, 2 bad usage, 3 a file cannot be read or written or is another one, 130
interrupted.
)";

struct AgainCommand {
    std::string file;
    std::string image;
    std::vector<std::string> outputs;
    bool quiet = false;
};

// How a file was made, as it says itself.
struct Recorded {
    std::string command;
    std::string version;
    std::string image_sha256;
};

// What lies between two marks; empty if they are not there.
std::string between(std::string_view text, std::string_view before, std::string_view after) {
    const std::size_t at = text.find(before);
    if (at == std::string_view::npos) return "";
    text.remove_prefix(at + before.size());
    return std::string(text.substr(0, text.find(after)));
}

// What drawing::in_xml() made XML of.
std::string without_xml(std::string text) {
    for (const auto& [name, meant] : {std::pair{"&lt;", "<"}, std::pair{"&amp;", "&"}})
        for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; ++at)
            text.replace(at, std::string_view(name).size(), meant);
    return text;
}

// A text of the .json, whose points are not parsed for it.
std::string recorded_text(std::string_view json, const std::string& key) {
    const std::string mark = "\"" + key + "\":\"";
    const std::size_t at = json.find(mark);
    if (at == std::string_view::npos) return "";
    const std::size_t begin = at + mark.size();
    std::size_t end = begin;
    while (end < json.size() && json[end] != '"') end += json[end] == '\\' ? 2U : 1U;
    const auto text = nlohmann::json::parse(
        "\"" + std::string(json.substr(begin, end - begin)) + "\"", nullptr, false);
    return text.is_string() ? text.get<std::string>() : "";
}

Recorded recorded_in(const std::string& path) {
    const std::string bytes = files::read_whole(path);
    Recorded made{recorded_text(bytes, "command"), recorded_text(bytes, "version"),
                  recorded_text(bytes, "image_sha256")};
    if (made.command.empty())
        made = {without_xml(between(bytes, "<dc:source>", "</dc:source>")),
                between(bytes, "<dc:creator>Lacuna ", "</dc:creator>"),
                between(bytes, "<dc:relation>sha256:", "</dc:relation>")};
    if (made.command.empty())
        throw FileError(files::name_of(path) +
                        ": records no command: must be an .svg or .json that lacuna has made");
    return made;
}

// The words of a line that options::quoted() wrote.
std::vector<std::string> words_of_shell(std::string_view line) {
    std::vector<std::string> words(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\'')
            is_quoted = !is_quoted;
        else if (line[i] == ' ' && !is_quoted)
            words.emplace_back();
        else if (line[i] == '\\' && !is_quoted && i + 1 < line.size())
            words.back() += line[++i];
        else
            words.back() += line[i];
    }
    return words;
}

// The words behind `lacuna`. Files may come from anywhere: none may say which files are written.
std::vector<std::string> checked_words(const std::string& path, const std::string& command) {
    std::vector<std::string> words = words_of_shell(command);
    const auto refuse = [&](const std::string& what) {
        throw FileError(fmt::format("{}: records {}, which no file of lacuna does",
                                    files::name_of(path), what));
    };
    const auto which = options::command_called(words.size() < 2 ? "" : words[1]);
    constexpr options::Commands kMakers =
        options::kSample | options::kStipple | options::kRelax | options::kOrder;
    if (words[0] != "lacuna" || !which || (*which & kMakers) == 0)
        refuse("the command " + shown(command));
    words.erase(words.begin());
    for (const std::string& word : words) {
        if (word.size() < 2 || word[0] != '-') continue;
        const options::Option* const option = options::find_option(*which, word.substr(2));
        const bool is_letter = std::isalpha(static_cast<unsigned char>(word[1])) != 0;
        if (is_letter || (word[1] == '-' && (option == nullptr || !option->traits.decides_points)))
            refuse(shown(word));
    }
    return words;
}

// Puts the picture where the command has it, and checks that it is the one it was.
void find_picture(const AgainCommand& all, const Recorded& made, std::vector<std::string>& words) {
    if (words[0] != "stipple" || words.size() < 2 || words[1].starts_with("--")) {
        if (words[0] == "stipple")
            throw BadUsage(shown(all.file) + ": is one of a sequence, --frames, which makes all");
        if (!all.image.empty())
            throw BadUsage("IMAGE " + shown(all.image) + ": is for files of lacuna stipple");
        return;
    }
    if (!all.image.empty()) words[1] = all.image;
    if (words[1] == "-")
        throw BadUsage(shown(all.file) +
                       ": its picture came from standard input: give it as IMAGE");
    if (!std::filesystem::exists(words[1]))
        throw FileError(
            fmt::format("{}: there is no picture {}, of which it was made: give it as "
                        "IMAGE, after {}",
                        all.file, words[1], all.file));
    const std::string sha256 = files::sha256_of_bytes(files::read_whole(words[1]));
    if (!made.image_sha256.empty() && sha256 != made.image_sha256)
        throw FileError(
            fmt::format("{}: is another picture than {} was made of: its SHA-256 is "
                        "{:.12}..., not {:.12}...",
                        words[1], all.file, sha256, made.image_sha256));
}

void run(const AgainCommand& all, const std::function<void(CLI::App&)>& add_commands) {
    const Recorded made = recorded_in(all.file);
    std::vector<std::string> words = checked_words(all.file, made.command);
    find_picture(all, made, words);
    if (!all.quiet && made.version != LACUNA_VERSION)
        std::fputs(fmt::format("lacuna: {} is of Lacuna {}: this is {}, whose points may differ\n",
                               printable(all.file), printable(made.version), LACUNA_VERSION)
                       .c_str(),
                   stderr);
    for (const std::string& output : all.outputs) words.insert(words.end(), {"--output", output});
    if (all.quiet) words.emplace_back("--quiet");
    CLI::App app;
    app.name("lacuna");
    add_commands(app);
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
}

}  // namespace

void add_again(CLI::App& app, const std::function<void(CLI::App&)>& add_commands) {
    const auto all = std::make_shared<AgainCommand>();
    add_command(app, options::kAgain, kAgainDescription,
                {{"FILE", &all->file},
                 {"IMAGE", &all->image},
                 {"output", &all->outputs},
                 {"quiet", &all->quiet}},
                [all, add_commands](const CommandLine&) { run(*all, add_commands); });
}

}  // namespace lacuna::cli
