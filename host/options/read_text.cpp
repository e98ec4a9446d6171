// Splits a text into words, and words into options and their values.
#include "options/read_text.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::options {
namespace {

std::vector<std::string> words_of(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    std::vector<std::string> words;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
        if (text.empty()) return words;
        words.emplace_back(text.substr(0, text.find_first_of(kBlanks)));
        text.remove_prefix(words.back().size());
    }
}

// The option that a word names.
const Option& option_in(Commands command, const std::string& word, const Targets& targets) {
    const std::string name = word.starts_with("--") ? word.substr(2, word.find('=') - 2) : "";
    const Option* const option = name.empty() ? nullptr : find_option(command, name);
    if (option == nullptr)
        throw BadRequest("options", word,
                         "is no option of lacuna " + std::string(name_of_command(command)));
    if (!targets.contains(option->name))
        throw BadRequest("options", word, "is for the command alone");
    return *option;
}

}  // namespace

CommandLine read_text(Commands command, const char* text, const Targets& targets,
                      const std::vector<std::string_view>& besides) {
    CommandLine line{command, {}};
    for (const std::string_view name : besides) line.given.push_back({name, {"given"}});
    const std::vector<std::string> words = words_of(text == nullptr ? "" : text);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const Option& option = option_in(command, word, targets);
        const std::string name(option.name);
        if (line.has(name) && !option.traits.repeats)
            throw BadRequest("options", word, "is given twice");
        GivenOption& given = line.given.emplace_back();
        given.name = option.name;
        const std::size_t equals = word.find('=');
        if (equals != std::string::npos)
            given.values.push_back(word.substr(equals + 1));
        else if (option.kind != Kind::flag && i + 1 < words.size() &&
                 !words[i + 1].starts_with("--"))
            given.values.push_back(words[++i]);
        else if (!option.traits.usual.empty())
            given.values.emplace_back(option.traits.usual);
        if (given.values.empty() != (option.kind == Kind::flag))
            throw BadRequest("options", word,
                             given.values.empty() ? "needs a value" : "has no value");
    }
    line.sort();
    read(line, targets);
    return line;
}

}  // namespace lacuna::options
