// By how much some work raises the program's peak memory.
#pragma once

#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace lacuna::cli {

// Reads Linux's counts in /proc/self; without them the result is unset.
class PeakMemory {
public:
    // Starts to measure the peak.
    PeakMemory() {
        malloc_trim(0);  // gives freed memory back, which the work would otherwise use uncounted
        std::ofstream("/proc/self/clear_refs") << "5";
        held_ = bytes("VmRSS:");
    }
    std::optional<std::uint64_t> raised_bytes() const {
        const auto peak = bytes("VmHWM:");
        if (!held_ || !peak) return std::nullopt;
        return *peak - std::min(*held_, *peak);
    }

private:
    static std::optional<std::uint64_t> bytes(std::string_view name) {
        std::ifstream status("/proc/self/status");
        std::string word;
        while (status >> word) {
            std::uint64_t kibibytes = 0;
            if (word == name && status >> kibibytes) return kibibytes * 1024;
            status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        }
        return std::nullopt;
    }

    std::optional<std::uint64_t> held_;
};

}  // namespace lacuna::cli
