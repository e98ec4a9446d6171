// Where the values of options go: the members of the structs that the library is given. The command
// and the page read texts into them, Python reads its own values, and reports write them.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/stipple.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "options/make.h"
#include "options/options.h"

namespace lacuna::options {

// A function that reads a text into what `to` points to.
struct Take {
    void (*read)(const std::string& text, void* to);
    void* to;
};
template <auto kRead, class To>
Take take_by(To& to) {
    return {[](const std::string& text, void* there) { kRead(text, *static_cast<To*>(there)); },
            &to};
}

// A variable or a function. Nothing but pointers, which keeps lists of targets small.
using Target = std::variant<bool*, std::optional<bool>*, Boundary*, double*, std::optional<double>*,
                            std::uint32_t*, std::optional<std::uint32_t>*, std::uint64_t*,
                            std::optional<std::uint64_t>*, std::string*, std::vector<std::string>*,
                            std::optional<Mode>*, std::optional<Metric>*, Take>;

// The targets of options by their names in the table, without dashes.
using Targets = std::map<std::string_view, Target>;

Targets targets_of(Request& request);
Targets targets_of(Moves& moves);
Targets targets_of(Tone& tone);
// Of dots of one size on paper: dot-size, paper-size and margin. Link lacuna::extras.
Targets targets_of(std::optional<Pens>& pens, std::optional<Paper>& paper);
// With those of its request, its tone and its paper. Link lacuna::extras.
Targets targets_of(StippleOptions& options);

// Throws BadRequest if the option must be one of some words and the text is none of them.
void check_word(const Option& option, const std::string& text);

// Reads the text of an option into its target. Throws BadRequest for a text that is no value.
void read(const Option& option, const std::string& text, const Target& target);

// Reads all options of a line that have a target. Throws BadRequest as the last function and
// refuse_pairs() do.
void read(const CommandLine& line, const Targets& targets);

// A value as it is; null where there is none.
using Value = std::variant<std::nullptr_t, bool, double, std::uint64_t, std::string>;
// The value of a target; null for a function.
Value value_of(const Target& target);

// The options of a command whose values differ from the usual ones, as if they had been given.
// Functions have no values.
std::vector<GivenOption> given_in(Commands command, const Targets& targets, const Targets& usual);

}  // namespace lacuna::options
