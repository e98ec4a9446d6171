// The options of programs that make random requests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lacuna::tests {

struct HostileOptions {
    std::optional<double> seconds;
    std::uint64_t seed = std::random_device()();
    std::uint64_t skip = 0;
};

// Reads options named in `known`, each with a value. Throws std::invalid_argument with the reason.
inline HostileOptions read_hostile_options(int argc, char** argv,
                                           std::span<const std::string_view> known) {
    HostileOptions options;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            std::string all;
            for (const std::string_view one : known) all.append(" ").append(one);
            throw std::invalid_argument(name + ": must be one of" + all);
        }
        if (i + 1 == argc) throw std::invalid_argument(name + ": needs a value");
        const std::string value = argv[i + 1];
        try {
            if (name == "--seconds") options.seconds = std::stod(value);
            if (name == "--seed") options.seed = std::stoull(value);
            if (name == "--skip") options.skip = std::stoull(value);
        } catch (const std::logic_error&) {
            throw std::invalid_argument(name + " " + value + ": must be a number");
        }
    }
    return options;
}

}  // namespace lacuna::tests
