// What a machine must have for all tests: without it they are skipped, unless CI requires it.
#pragma once

#include <cstdlib>
#include <string_view>

namespace lacuna::tests {

// Whether the environment variable LACUNA_REQUIRE holds `name`, such as a backend's: the tests that
// need it then fail where it is missing.
inline bool is_required(std::string_view name) {
    const char* const required = std::getenv("LACUNA_REQUIRE");
    return required != nullptr && std::string_view(required).find(name) != std::string_view::npos;
}

}  // namespace lacuna::tests
