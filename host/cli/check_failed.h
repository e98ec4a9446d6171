// What a command throws when it has done its work and the answer is no.
#pragma once

#include <exception>

namespace lacuna::cli {

// A check came out badly, and all that is to say of it has been printed: the exit code is 1.
class CheckFailed : public std::exception {};

}  // namespace lacuna::cli
