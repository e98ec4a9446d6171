// Runs a command line.
#include "cli/terminal/run_program.h"

#include <fmt/core.h>
#include <signal.h>
#include <sys/resource.h>

#include <lacuna/lacuna.h>
#include <lacuna/version.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "cli/terminal/completion.h"
#include "files/point_files.h"
#include "options/options.h"

namespace lacuna::cli {
namespace {

// Lists each command by the first line of its description, without its examples; and of a command
// with more options than a screen has lines those that everybody needs, unless all are asked for.
class Formatter : public CLI::Formatter {
public:
    std::string make_subcommand(const CLI::App* command) const override {
        std::ostringstream out;
        const std::string all = command->get_description();
        CLI::detail::format_help(out, command->get_display_name(true),
                                 all.substr(0, all.find('\n')), column_width_);
        return out.str();
    }
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        const auto command = options::command_called(app->get_name());
        const auto all =
            app->get_options([](const CLI::Option* one) { return one->nonpositional(); });
        if (mode != CLI::AppFormatMode::Normal || !command || all.size() <= kFewOptions)
            return CLI::Formatter::make_help(app, std::move(name), mode);
        std::vector<const CLI::Option*> some;
        for (const CLI::Option* const one : all) {
            const auto* const row = options::find_option(*command, one->get_single_name());
            if (row == nullptr || options::is_in_short_help(*command, *row)) some.push_back(one);
        }
        return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
               make_group("Options", false, some) +
               fmt::format("\nThe other {} options: lacuna {} --help-all\n",
                           all.size() - some.size(), app->get_name());
    }

private:
    static constexpr std::size_t kFewOptions = 20;
};

std::string version_of(const Program& program) {
    return program.name() + " " + LACUNA_VERSION;
}

// `lacuna help [COMMAND]` and `lacuna version`, as many programs have them.
void add_help_and_version(CLI::App& app, const Program& program) {
    CLI::App& help = *app.add_subcommand("help", "Prints this help, or the help of a command.");
    const auto name = std::make_shared<std::string>();
    help.add_option("COMMAND", *name, "A command that " + program.name() + " --help lists")
        ->type_name("");
    help.group("");  // not listed: everybody knows it, and it has no manual page
    help.callback([&app, &program, name] {
        if (name->empty())
            return program.say(
                app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
        const auto named = app.get_subcommands(
            [&](const CLI::App* command) { return command->get_name() == *name; });
        if (named.empty())
            throw BadUsage(fmt::format("{}: no such command{}; see {} --help", shown(*name),
                                       nearest_text(*name, names_of_commands(app)),
                                       program.name()));
        program.say(named.front()->help(app.get_name()));
    });
    CLI::App& version = *app.add_subcommand("version", "Prints the version, as --version does.");
    version.group("");
    version.callback([&program] { program.say(version_of(program) + "\n"); });
}

bool takes_arguments(const CLI::App& command) {
    const auto options = command.get_options();
    return std::any_of(options.begin(), options.end(),
                       [](const CLI::Option* option) { return option->get_positional(); });
}

// ", see OPTION" with the first option whose help has the word, such as strokes.
std::string option_that_explains(const CLI::App& command, const std::string& word) {
    for (const CLI::Option* option : command.get_options())
        if ((" " + option->get_description()).find(" " + word) != std::string::npos)
            return ", see " + option->get_name();
    return "";
}

// The message for a word that is neither a command, nor an option or argument of `command`.
std::string explain_extra(const CLI::App& app, const std::string& extra, const CLI::App* command) {
    if (command == nullptr)
        return fmt::format("{}: no such command or option{}", shown(extra),
                           nearest_text(extra, extra.starts_with("-") ? names_of_options(app)
                                                                      : names_of_commands(app)));
    const std::vector<std::string> options = names_of_options(*command);
    const std::string_view arguments =
        takes_arguments(*command) ? "no more arguments are taken" : "no arguments are taken";
    if (extra.starts_with("-")) {
        constexpr std::size_t kShortestWord = 5;
        std::string meant = nearest_text(extra, options);
        if (const std::string word = extra.substr(std::min(extra.size(), std::size_t{2}));
            meant.empty() && word.size() >= kShortestWord)
            meant = option_that_explains(*command, word);
        return fmt::format("{}: no such option, and {}{}", shown(extra), arguments, meant);
    }
    // Typical mistakes are `stipple photo.jpg dots.svg`, `stipple *.png` and `sample help`. A file
    // that exists must not be written over because of a message.
    std::string meant;
    const bool exists = std::filesystem::exists(extra);
    if (!exists && command->get_option_no_throw("--output") != nullptr &&
        files::find_format_of(extra) != nullptr)
        meant = ", did you mean -o " + shown(extra) + "?";
    if (exists && command->get_name() == "stipple")
        meant = ": one picture is stippled, or several with --frames 'PATTERN', in quotes";
    if (std::find(options.begin(), options.end(), "--" + extra) != options.end())
        meant = ", did you mean --" + extra + "?";
    return fmt::format("{}: {}{}", shown(extra), arguments, meant);
}

// Rewrites CLI11's messages: they begin with the option's name but do not say what is allowed.
std::string explain(const CLI::App& app, const CLI::ParseError& error, const std::string& extra,
                    const CLI::App* command) {
    if (!extra.empty()) return explain_extra(app, extra, command);
    std::string what = error.what();
    const std::string option = what.substr(0, what.find_first_of(": "));
    if (what.ends_with(" missing")) return option + ": a value must follow";
    if (what.find("At Most") != std::string::npos) return option + ": must be given only once";
    if (what.ends_with("flag override")) return "--" + option + ": takes no value";
    if (error.get_name() == "RequiredError" && command == nullptr) return "a command must follow";
    // Users who pipe a picture in may not know that - is needed.
    if (what == "IMAGE is required") return what + " (- is standard input)";
    return what;
}

// Handles errors that CLI11 finds, and --help and --version, which it throws as well.
int finish(const Program& program, const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        std::ostringstream said;
        app.exit(error, said, std::cerr);
        program.say(said.str());
        return 0;
    }
    const auto chosen = app.get_subcommands();
    const std::string name =
        chosen.empty() ? program.name() : program.name() + " " + chosen.front()->get_name();
    const auto extras = app.remaining(true);
    const std::string message = explain(app, error, extras.empty() ? "" : extras.front(),
                                        chosen.empty() ? nullptr : chosen.front());
    return program.fail(kExitBadUsage, fmt::format("{}; see {} --help", message, name));
}

// The words of the command line. -o=FILE becomes -oFILE: CLI11 would take the equals sign for the
// first character of the value.
std::vector<std::string> words_of(std::span<char*> arguments) {
    std::vector<std::string> words(arguments.begin(), arguments.end());
    for (std::string& word : std::span(words.begin(), std::find(words.begin(), words.end(), "--")))
        if (word.size() > 3 && word[0] == '-' && word[1] != '-' && word[2] == '=') word.erase(2, 1);
    return words;
}

int parse_and_run(const Program& program, int argc, char** argv) {
    CLI::App app(program.description());
    try {
        app.name(program.name());
        app.formatter(std::make_shared<Formatter>());
        app.set_help_all_flag("--help-all", "Print this help with all options");
        app.set_version_flag("-V,--version", version_of(program), "Print the version");
        app.require_subcommand(1);
        program.add_commands(app);
        add_help_and_version(app, program);
        const std::vector<std::string> words = words_of({argv + 1, argv + argc});
        if (!words.empty() && words.front() == "__words") {  // for the completions of shells
            program.say(words_at(app, std::span(words).subspan(1)));
            return 0;
        }
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return 0;
    } catch (const CLI::ParseError& error) {
        return finish(program, app, error);
    }
}

// Ends silently by SIGPIPE, like a program without a handler: `| head -1` is no error.
int end_by_closed_pipe() {
    signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
    return 128 + SIGPIPE;
}

// A stack overflow is a crash without a message. Drivers' threads have stacks of the same size.
void check_stack() {
    constexpr rlim_t kLeastStack = rlim_t{256} << 10U;
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kLeastStack) return;
    throw BadUsage(fmt::format("the stack is limited to {} KiB (ulimit -s): must be at least {}",
                               limit.rlim_cur >> 10U, kLeastStack >> 10U));
}

}  // namespace

// Uses fmt's escapes, which know Unicode. fmt would escape quotes and backslashes too, so the text
// is passed to it in pieces between them.
std::string printable(std::string_view text) {
    constexpr std::string_view kMayStay = "\"\\";
    std::string result;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find_first_of(kMayStay), text.size());
        const std::string quoted = fmt::format("{:?}", text.substr(0, length));
        result += quoted.substr(1, quoted.size() - 2);
        text.remove_prefix(length);
        if (text.empty()) break;
        result += text.front();
        text.remove_prefix(1);
    }
    return result;
}

int Program::fail(int code, const std::string& message) const {
    std::fputs(fmt::format("{}: {}\n", name_, printable(message)).c_str(), stderr);
    return code;
}

void Program::say(const std::string& text) const {
    files::write_whole("-", text);
}

int run_program(const Program& program, int argc, char** argv) {
    // With these signals ignored, a closed pipe and a file that is too large are errors of write().
    const bool ignores_pipes = signal(SIGPIPE, SIG_IGN) == SIG_IGN;
    signal(SIGXFSZ, SIG_IGN);
    try {
        check_stack();
        return parse_and_run(program, argc, argv);
    } catch (const BadRequest& error) {
        return program.fail(kExitBadUsage, std::string("--") + error.what());
    } catch (const BadUsage& error) {
        return program.fail(kExitBadUsage, error.what());
    } catch (const CheckFailed&) {
        return kExitCheckFailed;
    } catch (const files::ClosedPipe& error) {
        return ignores_pipes ? program.fail(kExitFile, error.what()) : end_by_closed_pipe();
    } catch (const files::FileError& error) {
        return program.fail(kExitFile, error.what());
    } catch (const Unavailable& error) {
        return program.fail(kExitDevice, error.what());
    } catch (const DeviceError& error) {
        return program.fail(kExitDevice, error.what());
    } catch (const std::bad_alloc&) {
        return program.fail(kExitBadUsage, "out of memory: ask for fewer points");
    } catch (const std::exception& error) {
        return program.fail(kExitBug, fmt::format("this is a bug: {}", error.what()));
    }
}

}  // namespace lacuna::cli
