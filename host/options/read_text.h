// The options of a command from one text, as a caller in C gives them.
#pragma once

#include <string_view>
#include <vector>

#include "options/options.h"
#include "options/targets.h"

namespace lacuna::options {

// Reads the words of the text, between blanks, as the command reads its arguments: --name value or
// --name=value. A null text has no words. Throws BadRequest as read() does, and for a word that is
// no option of the command, for an option that has no target, and for one given twice. `besides`
// are options whose files' contents are given in another way: they exclude and need others, too.
CommandLine read_text(Commands command, const char* text, const Targets& targets,
                      const std::vector<std::string_view>& besides = {});

}  // namespace lacuna::options
