// By how much a piece of work raises the program's memory.
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

// As Linux counts it in /proc/self; none where it does not tell.
class PeakMemory {
public:
    // From here on the peak counts.
    PeakMemory() {
        malloc_trim(0);  // what was freed must not serve the next for nothing
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
