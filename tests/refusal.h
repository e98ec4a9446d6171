// The message for a request that cannot be met.
#pragma once

#include <lacuna/lacuna.h>

#include <string>

namespace lacuna::tests {

// The message of the BadRequest that `act` throws, or "accepted".
template <typename Act>
std::string refusal_of(Act act) {
    try {
        act();
    } catch (const BadRequest& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace lacuna::tests
