// The message for a request that cannot be met, or a file that cannot be read.
#pragma once

#include <lacuna/files.h>
#include <lacuna/lacuna.h>

#include <string>

namespace lacuna::tests {

// The message of the BadRequest or FileError that `act` throws, or "accepted".
template <typename Act>
std::string refusal_of(Act act) {
    try {
        act();
    } catch (const BadRequest& error) {
        return error.what();
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace lacuna::tests
