// The list of backends, and the choice among them. The page is built with LACUNA_CPU_ONLY.
#include "backends/backends.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "backends/cpu/cpu_backend.h"
#include "backends/device/choice.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/opencl_backend.h"
#endif
#ifdef LACUNA_VULKAN
#include "backends/vulkan/vulkan_backend.h"
#endif
#include "plan/sizes.h"

namespace lacuna {
namespace {

struct Entry {
    std::string_view name;
    // Throws Unavailable when there is no such device. Null: the backend has its own loop.
    std::unique_ptr<Backend> (*make)(const Plan&, const Placement&);
    bool has_devices;  // whether a request may name a device
    std::vector<DeviceEntry> (*list)();
};

std::vector<DeviceEntry> processor_with(unsigned threads) {
    DeviceEntry entry;
    entry.name = std::to_string(threads) + (threads == 1 ? " thread" : " threads");
    entry.kind = "cpu";
    entry.memory_bytes = machine_memory_bytes();
    entry.largest_buffer_bytes = entry.memory_bytes;
    return {entry};
}

std::vector<DeviceEntry> list_processor() {
    return processor_with(std::max(1u, std::thread::hardware_concurrency()));
}

#ifndef LACUNA_CPU_ONLY
std::vector<DeviceEntry> list_one_thread() {
    return processor_with(1);
}
#endif

#if !defined(LACUNA_OPENCL) || !defined(LACUNA_VULKAN)
constexpr char kOpenCl[] = "opencl";
constexpr char kVulkan[] = "vulkan";
constexpr const char* kLeftOut = "this build was made without it";

template <const char* name>
std::unique_ptr<Backend> make_left_out(const Plan&, const Placement&) {
    throw Unavailable("backend " + std::string(name) + ": " + kLeftOut);
}

std::vector<DeviceEntry> list_left_out() {
    DeviceEntry entry;
    entry.unusable = kLeftOut;
    return {entry};
}
#endif

// In order of preference.
constexpr Entry kBackends[] = {
    {"cpu", cpu::make_backend, false, list_processor},
#ifdef LACUNA_OPENCL
    {"opencl", opencl::make_backend, true, opencl::list_devices},
#else
    {kOpenCl, make_left_out<kOpenCl>, true, list_left_out},
#endif
#ifdef LACUNA_VULKAN
    {"vulkan", vulkan::make_backend, true, vulkan::list_devices},
#else
    {kVulkan, make_left_out<kVulkan>, true, list_left_out},
#endif
#ifndef LACUNA_CPU_ONLY
    {"reference", nullptr, false, list_one_thread},
#endif
};

// A driver that fails is listed as an unusable device, so that it does not hide the others.
std::vector<DeviceEntry> list(const Entry& backend) {
    try {
        return backend.list();
    } catch (const DeviceError& error) {
        DeviceEntry entry;
        entry.unusable = error.what();
        const std::string prefix = "backend " + std::string(backend.name) + ": ";
        if (entry.unusable.starts_with(prefix)) entry.unusable.erase(0, prefix.size());
        return {entry};
    }
}

std::string names() {
    std::string all = "auto";
    for (const Entry& entry : kBackends) all += ", " + std::string(entry.name);
    return all;
}

const Entry& entry_for(const RunOn& run_on) {
    const std::string wanted = wanted_backend(run_on.backend);
    for (const Entry& entry : kBackends) {
        if (wanted != "auto" && wanted != entry.name) continue;
        if (!run_on.device.empty() && !entry.has_devices)
            throw BadRequest("device", run_on.device,
                             "backend " + std::string(entry.name) +
                                 " has no devices to choose from; opencl and vulkan have");
        return entry;
    }
    throw no_such_backend(wanted);
}

}  // namespace

std::string wanted_backend(const std::string& asked) {
    if (asked != "auto") return asked;
    const char* forced = std::getenv("LACUNA_BACKEND");
    return forced != nullptr && *forced != '\0' ? forced : "auto";
}

std::string backend_named(const RunOn& run_on) {
    return std::string(entry_for(run_on).name);
}

BadRequest no_such_backend(const std::string& wanted) {
    return BadRequest("backend", wanted, "must be one of " + names());
}

std::vector<Device> devices() {
    std::vector<Device> all;
    for (const Entry& entry : kBackends)
        for (const DeviceEntry& device : list(entry))
            all.push_back({std::string(entry.name), device.name, device.kind, device.memory_bytes,
                           device.largest_buffer_bytes, device.unusable});
    return all;
}

ReadyBackend make_backend(const RunOn& run_on, const Plan& plan, Observer& observer) {
    const Entry& entry = entry_for(run_on);
    if (entry.make == nullptr) return {nullptr, std::string(entry.name)};
    // A device's kernels are built here, at first use.
    observer.begin(Verb::first_use);
    std::unique_ptr<Backend> backend = entry.make(plan, {run_on.device, run_on.threads});
    observer.end(Verb::first_use);
    return {std::move(backend), std::string(entry.name)};
}

}  // namespace lacuna
