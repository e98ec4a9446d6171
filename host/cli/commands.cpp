// Runs a command line.
#include "cli/commands.h"

#include <fmt/core.h>
#include <signal.h>

#include <lacuna/lacuna.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>

#include "cli/analyze.h"
#include "cli/check_failed.h"
#include "cli/compare.h"
#include "cli/devices.h"
#include "cli/interruption.h"
#include "cli/options.h"
#include "cli/reproduce.h"
#include "cli/sample.h"
#include "cli/stipple.h"
#include "cli/verify.h"
#include "files/point_files.h"

namespace lacuna::cli {
namespace {

constexpr int kExitCheckFailed = 1;
constexpr int kExitBadUsage = 2;
constexpr int kExitFile = 3;
constexpr int kExitDevice = 4;
constexpr int kExitBug = 70;  // EX_SOFTWARE of sysexits.h

constexpr const char* kDescription = R"(Makes blue-noise point sets.

Examples:
  lacuna sample --radius 0.01 -o points.svg
  lacuna sample --count 10000 --torus > points.txt
  lacuna stipple photo.jpg --count 20000 -o dots.svg
  lacuna sample --help
  lacuna verify points.txt --radius 0.01
  lacuna analyze points.txt -o sheet.pdf
  lacuna reproduce fig5 -o figures
  lacuna compare --radius 0.005
  lacuna devices
)";

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
    add_verify(app);
    add_analyze(app);
    add_reproduce(app);
    add_compare(app, sampler);
    add_devices(app);
}

int fail(int code, const std::string& message) {
    std::fputs(fmt::format("lacuna: {}\n", message).c_str(), stderr);
    return code;
}

int run(CLI::App& app, int argc, char** argv, const Sampler& sampler) {
    app.name("lacuna");
    app.formatter(std::make_shared<Formatter>());
    app.set_version_flag("--version", std::string("lacuna ") + LACUNA_VERSION, "Print the version");
    app.require_subcommand(1);
    add_commands(app, sampler);
    app.parse(argc, argv);
    return 0;
}

bool takes_arguments(const CLI::App& command) {
    const auto options = command.get_options();
    return std::any_of(options.begin(), options.end(),
                       [](const CLI::Option* option) { return option->get_positional(); });
}

// CLI11's messages begin with the option's name and leave out what is allowed.
std::string explain(const CLI::ParseError& error, const std::string& extra,
                    const CLI::App* command) {
    if (!extra.empty()) {
        const std::string_view wanted = command == nullptr ? "command or option"
                                        : takes_arguments(*command)
                                            ? "option, and no more arguments are taken"
                                            : "option, and no arguments are taken";
        return fmt::format("{}: no such {}", shown(extra), wanted);
    }
    std::string what = error.what();
    const std::string option = what.substr(0, what.find_first_of(": "));
    if (what.ends_with(" missing")) return option + ": a value must follow";
    if (what.find("At Most") != std::string::npos) return option + ": must be given only once";
    if (what.ends_with("flag override")) return "--" + option + ": takes no value";
    if (error.get_name() == "RequiredError" && command == nullptr) return "a command must follow";
    return what;
}

// What CLI11 itself objects to, and --help and --version, which it throws too.
int finish(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        app.exit(error, std::cout, std::cerr);
        return std::cout.flush() ? 0 : fail(kExitFile, "cannot write to standard output");
    }
    const auto chosen = app.get_subcommands();
    const std::string name = chosen.empty() ? "lacuna" : "lacuna " + chosen.front()->get_name();
    const auto extras = app.remaining(true);
    const std::string message = explain(error, extras.empty() ? "" : extras.front(),
                                        chosen.empty() ? nullptr : chosen.front());
    return fail(kExitBadUsage, fmt::format("{}; see {} --help", message, name));
}

}  // namespace

int run_commands(int argc, char** argv, const Sampler& sampler) {
    // A closed pipe and a file grown too large are then errors of write, told like any other.
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    CLI::App app(kDescription);
    try {
        return run(app, argc, argv, sampler);
    } catch (const CLI::ParseError& error) {
        return finish(app, error);
    } catch (const BadRequest& error) {
        return fail(kExitBadUsage, std::string("--") + error.what());
    } catch (const CheckFailed&) {
        return kExitCheckFailed;
    } catch (const files::FileError& error) {
        return fail(kExitFile, error.what());
    } catch (const Unavailable& error) {
        return fail(kExitDevice, error.what());
    } catch (const DeviceError& error) {
        return fail(kExitDevice, error.what());
    } catch (const Cancelled&) {
        return fail(kExitInterrupted, "interrupted, nothing was written");
    } catch (const std::bad_alloc&) {
        return fail(kExitBadUsage, "out of memory: ask for fewer points");
    } catch (const std::exception& error) {
        return fail(kExitBug, fmt::format("this is a bug: {}", error.what()));
    }
}

}  // namespace lacuna::cli
