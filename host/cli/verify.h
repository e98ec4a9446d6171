// `lacuna verify`: proves or refutes that the points of a file are a maximal Poisson-disk set.
#pragma once

#include <CLI/CLI.hpp>
#include <exception>

namespace lacuna::cli {

// The points do not keep what was to be proven; all that is to say has been printed.
class NotProven : public std::exception {};

// Adds the command to `app`, which runs it after parsing. Throws BadRequest, files::FileError and
// NotProven.
void add_verify(CLI::App& app);

}  // namespace lacuna::cli
