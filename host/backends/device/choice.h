// What the device backends tell of their devices, and how one is chosen by number or name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lacuna {

// A device, or what stands where one was hoped for, as `lacuna devices` lists it.
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

// Why this process cannot use a device: it was forked from one that did, whose drivers' threads
// stayed behind. Empty where it can. To be asked before anything else of a driver.
std::string why_forked();

}  // namespace device
}  // namespace lacuna
