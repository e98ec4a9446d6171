// The devices of the device backends, and how one is chosen by number or name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lacuna {

// An entry of `lacuna devices`: a device, or the reason why there is none.
struct DeviceEntry {
    std::string name;  // as the driver gives it
    std::string kind;  // cpu, gpu or other
    bool has_int64 = false;
    bool has_fp64 = false;  // not needed: square roots are corrected exactly without it
    std::uint64_t memory_bytes = 0;
    std::uint64_t largest_buffer_bytes = 0;
    std::string unusable;  // why it cannot be used; empty when it can
};

namespace device {

// The entry that `wanted` asks for: a number, a part of a name in any case, or nothing, which means
// the first usable gpu, or else the first usable device. Throws Unavailable, with the list.
std::size_t choose(std::string_view backend, std::span<const DeviceEntry> entries,
                   std::string_view wanted);

// Why this process cannot use a device: it was forked from a process that did, and a fork does not
// copy the drivers' threads. Empty where it can. Ask this before any other call of a driver.
std::string why_forked();

}  // namespace device
}  // namespace lacuna
