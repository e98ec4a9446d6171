// The exception of a command that has done its work and has found a check failed.
#pragma once

#include <exception>

namespace lacuna::cli {

// The result has been printed. The exit code becomes 1.
class CheckFailed : public std::exception {};

}  // namespace lacuna::cli
