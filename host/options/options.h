// The table of options: what a person may give to which command, whichever front end they use.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options/words.h"

namespace lacuna::options {

// A command, or several: each is a bit.
using Commands = std::uint32_t;
inline constexpr Commands kSample = 1;
inline constexpr Commands kStipple = 2;
inline constexpr Commands kRelax = 4;
inline constexpr Commands kOrder = 8;
inline constexpr Commands kVerify = 16;
inline constexpr Commands kAnalyze = 32;
inline constexpr Commands kCompare = 64;
inline constexpr Commands kReproduce = 128;
inline constexpr Commands kDevices = 256;
inline constexpr Commands kMpiSample = 512;
inline constexpr Commands kMask = 1024;
inline constexpr Commands kAgain = 2048;

std::string_view name_of_command(Commands command);
// Unset if no command of the program lacuna has this name.
std::optional<Commands> command_called(std::string_view name);

enum class Kind {
    flag,
    number,
    whole,
    text,
    word,          // of Traits::words, which error messages and completions list
    read_file,     // a path
    obstacles,     // FILE or FILE:WIDTH, which is read
    places,        // FILE or NAME:FILE, which is read
    word_or_file,  // a word of Traits::words, or a path that is read
    written_file,  // a path
};

// What only some options have.
struct Traits {
    Words words = Words::none;    // which the value is one of, or is completed with
    std::string_view alias = {};  // another name
    std::string_view usual = {};  // the value if none follows; empty: one must follow
    bool repeats = false;         // it may be given several times
    bool is_required = false;
    // Whether it decides which points are made. The command line in files leaves others out.
    bool decides_points = true;
};

// A row of the table. An option whose help differs between commands has a row for each text.
struct Option {
    std::string_view name;    // without dashes; an argument without a name is in capitals
    std::string_view symbol;  // of its value, in --help
    Kind kind = Kind::flag;
    Commands commands = 0;  // that have it
    Traits traits = {};

    bool is_argument() const { return name.front() >= 'A' && name.front() <= 'Z'; }
    bool names_a_file() const {
        return kind == Kind::read_file || kind == Kind::obstacles || kind == Kind::places;
    }
    // Its name in JSON and in Python.
    std::string key() const;
};

// The rows of a command, in the order of its --help and of the command line in files.
std::vector<const Option*> options_of(Commands command);

// The row of a command's option, by its name or alias; null if it has none.
const Option* find_option(Commands command, std::string_view name);

// Of a row that these functions gave: under which heading --help-all lists it, and whether --help
// lists it where the command has many options.
std::string_view heading_of(const Option& option);
bool is_in_short_help(Commands command, const Option& option);

// The help of a row that these functions gave. It may name kinds of files: {read}, {written} or
// {pictures} stands for the extensions of those that can be read, written, or written as pictures.
std::string_view help_of(const Option& option);

// An option that was given, or whose member of a request is set, and its values as texts.
struct GivenOption {
    std::string_view name;              // as in the table
    std::vector<std::string> values{};  // empty for a flag, and where no rule asks for the value
};

// What one call of a command was given, in the order of the table.
struct CommandLine {
    Commands command;
    std::vector<GivenOption> given;

    bool has(std::string_view name) const;
    // Puts the options into the order of the table.
    void sort();
    // The line for a shell, of the options that decide which points are made: arguments first, then
    // options in the order of the table. Instead of --seeds it has the --seed of one set.
    std::string text(std::uint64_t seed) const;
};

// Quotes a word so that a shell reads it as one.
std::string quoted(const std::string& word);
// The same for a path, which must not look like an option.
std::string quoted_path(const std::string& path);

// Throws BadRequest for one of `given` that needs another one which is not among them, or that
// excludes one which is. A number that switches an option off, as in --relax 0, is as good as none.
void refuse_pairs(Commands command, std::span<const GivenOption> given);

}  // namespace lacuna::options
