// The options of hostile.
#pragma once

#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lacuna::tests {

struct HostileOptions {
    bool samples = true, stipples = true, in_space = true;
    std::uint64_t requests = 0;  // after all pairs are covered
    std::uint64_t seed = std::random_device()();
    std::uint64_t skip = 0;
    std::string only{};
    std::string on{};  // a backend, in place of all
};

// Throws std::invalid_argument with the reason.
inline HostileOptions read_hostile_options(int argc, char** argv) {
    HostileOptions options;
    const auto number = [](const std::string& name, const std::string& value) {
        try {
            return std::stoull(value);
        } catch (const std::logic_error&) {
            throw std::invalid_argument(name + " " + value + ": must be a number");
        }
    };
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "sample" || name == "stipple" || name == "space") {
            options.samples = name == "sample";
            options.stipples = name == "stipple";
            options.in_space = name == "space";
            continue;
        }
        constexpr std::string_view kKnown = "--requests --seed --skip --only --on ";
        if (kKnown.find(name + " ") == kKnown.npos)
            throw std::invalid_argument(name + ": must be sample, stipple, space or one of " +
                                        std::string(kKnown));
        if (++i == argc) throw std::invalid_argument(name + ": needs a value");
        const std::string value = argv[i];
        if (name == "--requests") options.requests = number(name, value);
        if (name == "--seed") options.seed = number(name, value);
        if (name == "--skip") options.skip = number(name, value);
        if (name == "--only") options.only = value;
        if (name == "--on") options.on = value;
    }
    return options;
}

}  // namespace lacuna::tests
