// Records the origin of a set.
#include "cli/options/origin.h"

#include <lacuna/version.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lacuna::cli {
namespace {

constexpr std::array<std::string_view, 8> kDecideNothing{
    "--output", "--format", "--report", "--quiet", "--backend", "--device", "--threads", "--help"};

// Quotes `word` so that a shell reads it as one word.
std::string quoted(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:=,+%@";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string result = "'";
    for (const char c : word) {
        if (c == '\'') {
            result += "'\\''";
        } else {
            result += c;
        }
    }
    return result + "'";
}

// Positional arguments first, then options in the order of --help. --seeds becomes the --seed of
// this set.
std::string command_line(const CLI::App& command, std::uint64_t seed) {
    std::string line = "lacuna " + command.get_name();
    const CLI::Option* const seeds = command.get_option_no_throw("--seeds");
    const bool has_seeds = seeds != nullptr && seeds->count() > 0;
    for (const bool files : {true, false})
        for (const CLI::Option* option : command.get_options()) {
            const std::string name = option->get_name();
            if (name == "--seeds") continue;
            if (name == "--seed" && has_seeds && !files) line += " --seed " + std::to_string(seed);
            if (option->count() == 0 || option->get_positional() != files ||
                std::find(kDecideNothing.begin(), kDecideNothing.end(), name) !=
                    kDecideNothing.end())
                continue;
            if (option->get_expected_max() == 0) {  // a flag
                line += " " + name;
                continue;
            }
            // An option that may be given several times is given with each of its values.
            for (const std::string& value : option->results()) {
                if (!files) line += " " + name;
                const bool looks_like_an_option = files && value.starts_with("-") && value != "-";
                line += " " + quoted(looks_like_an_option ? "./" + value : value);
            }
        }
    return line;
}

}  // namespace

files::Origin origin_of(const CLI::App& command, const Request& request, const Result& result) {
    return origin_of(command, request, result, Json::object());
}

files::Origin origin_of(const CLI::App& command, const Request& request, const Result& result,
                        const Json& more) {
    Json options = what_decides(request, result);
    options.update(more);
    // File names are bytes, which need not be UTF-8.
    return {LACUNA_VERSION,
            command_line(command, request.seed),
            request.boundary,
            request.mode,
            request.seed,
            result.maximal,
            options.dump(-1, ' ', false, Json::error_handler_t::replace),
            result.levels,
            result.scale};
}

}  // namespace lacuna::cli
