// Makes CLI11's options of the rows of the table.
#include "cli/options/bind.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <stdexcept>
#include <utility>

#include "base/number_text.h"
#include "cli/options/domain_options.h"
#include "domains/rings.h"
#include "files/formats.h"

namespace lacuna::cli {
namespace {

using options::Kind;
using options::Option;

std::string full_help_of(const Option& row) {
    std::string help(options::help_of(row));
    for (const auto& [name, extensions] : {std::pair{"{read}", files::read_extensions()},
                                           {"{written}", files::written_extensions()},
                                           {"{pictures}", files::picture_extensions()}})
        if (const std::size_t at = help.find(name); at != std::string::npos)
            help.replace(at, std::string(name).size(), extensions);
    return help;
}

std::string names_of(const Option& row) {
    const std::string name(row.name);
    const std::string alias(row.traits.alias);
    if (row.is_argument()) return name;
    if (alias.empty()) return "--" + name;
    return alias.size() == 1 ? "-" + alias + ",--" + name : "--" + name + ",--" + alias;
}

// An argument has no name that a message could begin with.
void take(const Option& row, const std::string& text, const options::Target& target) {
    if (row.is_argument() && row.kind == Kind::word && !is_among(text, row.traits.words))
        throw CLI::ValidationError(shown(text) + ": must be " + listed(row.traits.words));
    options::read(row, text, target);
}

CLI::Option* add_option(CLI::App& command, const Option& row, const options::Target& target) {
    const std::string help = full_help_of(row);
    if (row.kind == Kind::flag)
        return command
            .add_flag_callback(
                names_of(row), [&row, target] { take(row, "", target); }, help)
            ->disable_flag_override();
    const auto take_text = [&row, target](const std::string& text) { take(row, text, target); };
    CLI::Option* option = nullptr;
    if (row.traits.repeats) {
        option = command.add_option_function<std::vector<std::string>>(
            names_of(row),
            [take_text](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) take_text(text);
            },
            help);
        // An option takes one value: -o must not take photo.jpg in `-o dots.svg photo.jpg`.
        if (!row.is_argument())
            option->expected(1)->allow_extra_args(false)->multi_option_policy(
                CLI::MultiOptionPolicy::TakeAll);
    } else {
        option = command.add_option_function<std::string>(names_of(row), take_text, help);
    }
    if (!row.traits.usual.empty())
        option->expected(0, 1)->default_str(std::string(row.traits.usual));
    return option->type_name(std::string(row.symbol))->required(row.traits.is_required);
}

}  // namespace

void add_command(CLI::App& app, options::Commands which, const std::string& description,
                 const Targets& targets, const std::function<void(const CommandLine&)>& run) {
    CLI::App& command =
        *app.add_subcommand(std::string(options::name_of_command(which)), description);
    std::vector<std::pair<const Option*, CLI::Option*>> options;
    for (const Option* row : options::options_of(which)) {
        const auto target = targets.find(row->name);
        if (target == targets.end())
            throw std::logic_error(fmt::format("no target for the option {}", row->name));
        options.emplace_back(row, add_option(command, *row, target->second));
        options.back().second->group(std::string(options::heading_of(*row)));
    }
    command.callback([which, options, run] {
        CommandLine line{which, {}};
        for (const auto& [row, option] : options)
            if (option->count() > 0)
                line.given.push_back({row->name, row->kind == Kind::flag
                                                     ? std::vector<std::string>{}
                                                     : option->results()});
        options::refuse_pairs(line.command, line.given);
        run(line);
    });
}

std::vector<GivenFile> files_read(const CommandLine& line) {
    std::vector<GivenFile> files;
    std::vector<std::string> classes;
    for (const auto& [name_in_table, values] : line.given)
        for (const std::string& value : values)
            if (name_in_table == "class") classes.push_back(value.substr(0, value.find(':')));
    for (const auto& [name_in_table, values] : line.given) {
        const Option& option = *options::find_option(line.command, name_in_table);
        const std::string name = (option.is_argument() ? "" : "--") + std::string(name_in_table);
        for (const std::string& value : values) {
            if (option.kind == Kind::read_file)
                files.push_back(
                    {name, name_in_table == "field" ? placed_picture(value).path : value});
            if (option.kind == Kind::obstacles)
                files.push_back({name, domains::file_and_layer(
                                           path_of_obstacles(class_and_path(value, classes).second))
                                           .file});
            if (option.kind == Kind::places)
                files.push_back(
                    {name, placed_picture(
                               domains::file_and_layer(class_and_path(value, classes).second).file)
                               .path});
            if (option.kind == Kind::word_or_file && !options::is_among(value, option.traits.words))
                files.push_back({name, value});
        }
    }
    return files;
}

}  // namespace lacuna::cli
