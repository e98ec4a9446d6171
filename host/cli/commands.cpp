// Runs a command line.
#include "cli/commands.h"

#include <fmt/core.h>
#include <signal.h>
#include <sys/resource.h>

#include <lacuna/lacuna.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/analyze.h"
#include "cli/check_failed.h"
#include "cli/compare.h"
#include "cli/devices.h"
#include "cli/exit_codes.h"
#include "cli/nearest.h"
#include "cli/options.h"
#include "cli/relax.h"
#include "cli/reproduce.h"
#include "cli/sample.h"
#include "cli/stipple.h"
#include "cli/verify.h"
#include "files/point_files.h"

namespace lacuna::cli {
namespace {

constexpr const char* kLacunaDescription = R"(Makes blue-noise point sets.

Examples:
  lacuna sample --radius 0.01 -o points.svg
  lacuna sample --count 10000 --torus > points.txt
  lacuna stipple photo.jpg --count 20000 -o dots.svg
  lacuna relax points.txt --torus -o even.npy
  lacuna sample --help
  lacuna verify points.txt --radius 0.01
  lacuna analyze points.txt -o sheet.pdf
  lacuna reproduce fig5 -o figures
  lacuna compare --radius 0.005
  lacuna devices
  lacuna help stipple                               the same as lacuna stipple --help
)";

const std::string kVersion = std::string("lacuna ") + LACUNA_VERSION;

// What is wrong with the command line, in one line.
class BadUsage : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Lists each command by the first line of its description, without its examples.
class Formatter : public CLI::Formatter {
public:
    std::string make_subcommand(const CLI::App* command) const override {
        std::ostringstream out;
        const std::string all = command->get_description();
        CLI::detail::format_help(out, command->get_display_name(true),
                                 all.substr(0, all.find('\n')), column_width_);
        return out.str();
    }
};

void add_commands(CLI::App& app, const Sampler& sampler) {
    add_sample(app);
    add_stipple(app);
    add_relax_command(app);
    add_verify(app);
    add_analyze(app);
    add_reproduce(app);
    add_compare(app, sampler);
    add_devices(app);
}

// `lacuna help [COMMAND]` and `lacuna version`, as many programs have them.
void add_help_and_version(CLI::App& app) {
    CLI::App& help = *app.add_subcommand("help", "Prints what --help prints, of a command too.");
    const auto name = std::make_shared<std::string>();
    help.add_option("COMMAND", *name, "One of those that lacuna --help lists")->type_name("");
    help.group("");  // listed nowhere: as familiar as --help, and no command with a manual page
    help.callback([&app, name] {
        if (name->empty())
            return files::write_whole("-", app.get_formatter()->make_help(
                                               &app, app.get_name(), CLI::AppFormatMode::Normal));
        const auto named = app.get_subcommands(
            [&](const CLI::App* command) { return command->get_name() == *name; });
        if (named.empty())
            throw BadUsage(fmt::format("{}: no such command{}; see lacuna --help", shown(*name),
                                       nearest_text(*name, names_of_commands(app))));
        files::write_whole("-", named.front()->help(app.get_name()));
    });
    CLI::App& version = *app.add_subcommand("version", "Prints the version, as --version does.");
    version.group("");
    version.callback([] { files::write_whole("-", kVersion + "\n"); });
}

int fail(int code, const std::string& message) {
    std::fputs(fmt::format("lacuna: {}\n", printable(message)).c_str(), stderr);
    return code;
}

int run(CLI::App& app, int argc, char** argv, const Sampler& sampler) {
    app.name("lacuna");
    app.formatter(std::make_shared<Formatter>());
    app.set_version_flag("-V,--version", kVersion, "Print the version");
    app.require_subcommand(1);
    add_commands(app, sampler);
    add_help_and_version(app);
    app.parse(argc, argv);
    return 0;
}

bool takes_arguments(const CLI::App& command) {
    const auto options = command.get_options();
    return std::any_of(options.begin(), options.end(),
                       [](const CLI::Option* option) { return option->get_positional(); });
}

// A word that is no command, no option of `command` and none of its arguments.
std::string explain_extra(const CLI::App& app, const std::string& extra, const CLI::App* command) {
    if (command == nullptr)
        return fmt::format("{}: no such command or option{}", shown(extra),
                           nearest_text(extra, extra.starts_with("-") ? names_of_options(app)
                                                                      : names_of_commands(app)));
    const std::vector<std::string> options = names_of_options(*command);
    const std::string_view arguments =
        takes_arguments(*command) ? "no more arguments are taken" : "no arguments are taken";
    if (extra.starts_with("-"))
        return fmt::format("{}: no such option, and {}{}", shown(extra), arguments,
                           nearest_text(extra, options));
    // `stipple photo.jpg dots.svg`, `sample help`.
    std::string meant;
    if (command->get_option_no_throw("--output") != nullptr &&
        files::find_format_of(extra) != nullptr)
        meant = ", did you mean -o " + shown(extra) + "?";
    if (std::find(options.begin(), options.end(), "--" + extra) != options.end())
        meant = ", did you mean --" + extra + "?";
    return fmt::format("{}: {}{}", shown(extra), arguments, meant);
}

// CLI11's messages begin with the option's name and leave out what is allowed.
std::string explain(const CLI::App& app, const CLI::ParseError& error, const std::string& extra,
                    const CLI::App* command) {
    if (!extra.empty()) return explain_extra(app, extra, command);
    std::string what = error.what();
    const std::string option = what.substr(0, what.find_first_of(": "));
    if (what.ends_with(" missing")) return option + ": a value must follow";
    if (what.find("At Most") != std::string::npos) return option + ": must be given only once";
    if (what.ends_with("flag override")) return "--" + option + ": takes no value";
    if (error.get_name() == "RequiredError" && command == nullptr) return "a command must follow";
    // Whoever pipes a picture in thinks that this is enough.
    if (what == "IMAGE is required") return what + " (- is standard input)";
    return what;
}

// What CLI11 itself objects to, and --help and --version, which it throws too.
int finish(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        std::ostringstream said;
        app.exit(error, said, std::cerr);
        files::write_whole("-", said.str());
        return 0;
    }
    const auto chosen = app.get_subcommands();
    const std::string name = chosen.empty() ? "lacuna" : "lacuna " + chosen.front()->get_name();
    const auto extras = app.remaining(true);
    const std::string message = explain(app, error, extras.empty() ? "" : extras.front(),
                                        chosen.empty() ? nullptr : chosen.front());
    return fail(kExitBadUsage, fmt::format("{}; see {} --help", message, name));
}

int parse_and_run(int argc, char** argv, const Sampler& sampler) {
    CLI::App app(kLacunaDescription);
    try {
        return run(app, argc, argv, sampler);
    } catch (const CLI::ParseError& error) {
        return finish(app, error);
    }
}

// Silently, as a program does that knows nothing of the signal: `| head -1` is no error.
int end_by_closed_pipe() {
    signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
    return 128 + SIGPIPE;
}

// A stack that runs out is a crash without a word, in drivers' threads too, whose stacks are as
// large.
void check_stack() {
    constexpr rlim_t kLeastStack = rlim_t{256} << 10U;
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kLeastStack) return;
    throw BadUsage(fmt::format("the stack is limited to {} KiB (ulimit -s): must be at least {}",
                               limit.rlim_cur >> 10U, kLeastStack >> 10U));
}

}  // namespace

int run_commands(int argc, char** argv, const Sampler& sampler) {
    // A closed pipe and a file grown too large are then errors of write.
    const bool ignores_pipes = signal(SIGPIPE, SIG_IGN) == SIG_IGN;
    signal(SIGXFSZ, SIG_IGN);
    try {
        check_stack();
        return parse_and_run(argc, argv, sampler);
    } catch (const BadRequest& error) {
        return fail(kExitBadUsage, std::string("--") + error.what());
    } catch (const BadUsage& error) {
        return fail(kExitBadUsage, error.what());
    } catch (const CheckFailed&) {
        return kExitCheckFailed;
    } catch (const files::ClosedPipe& error) {
        return ignores_pipes ? fail(kExitFile, error.what()) : end_by_closed_pipe();
    } catch (const files::FileError& error) {
        return fail(kExitFile, error.what());
    } catch (const Unavailable& error) {
        return fail(kExitDevice, error.what());
    } catch (const DeviceError& error) {
        return fail(kExitDevice, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kExitBadUsage, "out of memory: ask for fewer points");
    } catch (const std::exception& error) {
        return fail(kExitBug, fmt::format("this is a bug: {}", error.what()));
    }
}

}  // namespace lacuna::cli
