// The list of backends, and the choice among them.
#include "backends/backends.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "backends/cpu/make_backend.h"
#include "backends/device/choice.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/make_backend.h"
#endif
#include "backends/reference/reference.h"
#ifdef LACUNA_VULKAN
#include "backends/vulkan/make_backend.h"
#endif

namespace lacuna {
namespace {

struct Entry {
    std::string_view name;
    // Throws Unavailable when there is no such device.
    Run (*run)(const Request&, const Plan&, Observer&);
    bool has_devices;  // that a request may name
    std::vector<DeviceEntry> (*list)();
};

template <std::unique_ptr<Backend> (*make)(const Plan&, const Placement&)>
Run run_rounds(const Request& request, const Plan& plan, Observer& observer) {
    // A device's kernels are built here, at first use.
    observer.begin(Verb::first_use);
    const std::unique_ptr<Backend> backend = make(plan, {request.device, request.threads});
    observer.end(Verb::first_use);
    Run run;
    run.outcome = generate(plan, *backend, observer);
    run.device = backend->device();
    return run;
}

Run run_reference(const Request&, const Plan& plan, Observer& observer) {
    return {reference::sample(plan, observer), "", "1 thread"};
}

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

std::vector<DeviceEntry> list_one_thread() {
    return processor_with(1);
}

#if !defined(LACUNA_OPENCL) || !defined(LACUNA_VULKAN)
constexpr const char* kLeftOut = "this build was made without it";

Run run_left_out(const Request& request, const Plan&, Observer&) {
    throw Unavailable("backend " + request.backend + ": " + kLeftOut);
}

std::vector<DeviceEntry> list_left_out() {
    DeviceEntry entry;
    entry.unusable = kLeftOut;
    return {entry};
}
#endif

// In order of preference.
constexpr Entry kBackends[] = {
    {"cpu", run_rounds<cpu::make_backend>, false, list_processor},
#ifdef LACUNA_OPENCL
    {"opencl", run_rounds<opencl::make_backend>, true, opencl::list_devices},
#else
    {"opencl", run_left_out, true, list_left_out},
#endif
#ifdef LACUNA_VULKAN
    {"vulkan", run_rounds<vulkan::make_backend>, true, vulkan::list_devices},
#else
    {"vulkan", run_left_out, true, list_left_out},
#endif
    {"reference", run_reference, false, list_one_thread},
};

// A driver that fails is told of as one that cannot be used: it must not hide the others.
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

}  // namespace

std::string wanted_backend(const std::string& asked) {
    if (asked != "auto") return asked;
    const char* forced = std::getenv("LACUNA_BACKEND");
    return forced != nullptr && *forced != '\0' ? forced : "auto";
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

Run run_on_backend(const Request& request, const Plan& plan, Observer& observer) {
    const std::string wanted = wanted_backend(request.backend);
    for (const Entry& entry : kBackends) {
        if (wanted != "auto" && wanted != entry.name) continue;
        if (!request.device.empty() && !entry.has_devices)
            throw BadRequest("device", request.device,
                             "backend " + std::string(entry.name) +
                                 " has no devices to choose from; opencl and vulkan have");
        Run run = entry.run(request, plan, observer);
        run.backend = entry.name;
        return run;
    }
    throw no_such_backend(wanted);
}

}  // namespace lacuna
