// Makes CLI11's options of the rows of the table.
#include "cli/options/bind.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <stdexcept>
#include <utility>

#include "cli/options/obstacles.h"
#include "cli/options/options.h"
#include "files/formats.h"

namespace lacuna::cli {
namespace {

using recipes::Kind;
using recipes::Option;

std::string help_of(const Option& row) {
    std::string help(row.help);
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

void check_word(const Option& row, const std::string& text) {
    if (row.kind != Kind::word || recipes::is_among(text, row.traits.words)) return;
    const std::string allowed = "must be " + recipes::listed(row.traits.words);
    if (row.is_argument()) throw CLI::ValidationError(shown(text) + ": " + allowed);
    throw BadRequest(std::string(row.name), shown(text), allowed);
}

// Reads the text of an option into its target.
struct Reader {
    const Option& row;
    const std::string& text;

    template <class Number>
    void operator()(Number* number) const {
        read(std::string(row.name), text, *number);
    }
    void operator()(bool* flag) const { *flag = true; }
    void operator()(Boundary* boundary) const { *boundary = Boundary::torus; }
    void operator()(std::string* value) const { *value = text; }
    void operator()(std::vector<std::string>* values) const { values->push_back(text); }
    void operator()(std::optional<Mode>* mode) const {
        for (const Mode known : {Mode::exact, Mode::lines, Mode::cells, Mode::stratified})
            if (text == name_of(known)) *mode = known;
    }
    void operator()(std::optional<Metric>* metric) const {
        for (const Metric known : {Metric::min, Metric::mean, Metric::max})
            if (text == name_of(known)) *metric = known;
    }
    void operator()(const Take& take) const { take(text); }
};

CLI::Option* add(CLI::App& command, const Option& row, const Target& target) {
    const std::string help = help_of(row);
    if (row.kind == Kind::flag)
        return command
            .add_flag_callback(
                names_of(row),
                [&row, target] {
                    std::visit(Reader{row, ""}, target);
                },
                help)
            ->disable_flag_override();
    const auto take = [&row, target](const std::string& text) {
        check_word(row, text);
        std::visit(Reader{row, text}, target);
    };
    CLI::Option* option = nullptr;
    if (row.traits.repeats) {
        option = command.add_option_function<std::vector<std::string>>(
            names_of(row),
            [take](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) take(text);
            },
            help);
        // An option takes one value: -o must not take photo.jpg in `-o dots.svg photo.jpg`.
        if (!row.is_argument())
            option->expected(1)->allow_extra_args(false)->multi_option_policy(
                CLI::MultiOptionPolicy::TakeAll);
    } else {
        option = command.add_option_function<std::string>(names_of(row), take, help);
    }
    if (!row.traits.usual.empty())
        option->expected(0, 1)->default_str(std::string(row.traits.usual));
    return option->type_name(std::string(row.symbol))->required(row.traits.is_required);
}

}  // namespace

void add_command(CLI::App& app, recipes::Commands which, const std::string& description,
                 const Targets& targets, const std::function<void(const CommandLine&)>& run) {
    CLI::App& command =
        *app.add_subcommand(std::string(recipes::name_of_command(which)), description);
    std::vector<std::pair<const Option*, const CLI::Option*>> options;
    for (const Option* row : recipes::options_of(which)) {
        const auto target = targets.find(row->name);
        if (target == targets.end())
            throw std::logic_error(fmt::format("no target for the option {}", row->name));
        options.emplace_back(row, add(command, *row, target->second));
    }
    command.callback([which, options, run] {
        CommandLine line{which, {}};
        for (const auto& [row, option] : options)
            if (option->count() > 0)
                line.given.push_back({row->name, row->kind == Kind::flag
                                                     ? std::vector<std::string>{}
                                                     : option->results()});
        recipes::refuse_pairs(line);
        run(line);
    });
}

std::vector<GivenFile> files_read(const CommandLine& line) {
    std::vector<GivenFile> files;
    for (const auto& [name_in_table, values] : line.given) {
        const Option& option = *recipes::find_option(line.command, name_in_table);
        const std::string name = (option.is_argument() ? "" : "--") + std::string(name_in_table);
        for (const std::string& value : values) {
            if (option.kind == Kind::read_file) files.push_back({name, value});
            if (option.kind == Kind::obstacles) files.push_back({name, path_of_obstacles(value)});
            if (option.kind == Kind::word_or_file && !recipes::is_among(value, option.traits.words))
                files.push_back({name, value});
        }
    }
    return files;
}

}  // namespace lacuna::cli
