// The OpenCL devices of this machine, and what Lacuna needs of them.
#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "backends/opencl/device.h"
#include "backends/opencl/opencl_backend.h"

namespace lacuna::opencl {
namespace {

std::string kind_of(cl_device_type type) {
    if ((type & CL_DEVICE_TYPE_GPU) != 0) return "gpu";
    if ((type & CL_DEVICE_TYPE_CPU) != 0) return "cpu";
    return "other";
}

// The full profile includes 64-bit whole numbers and 32-bit atomics.
std::string why_unusable(const cl::Device& device) {
    if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "the driver says it is not available";
    if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "its driver has no compiler";
    if (device.getInfo<CL_DEVICE_PROFILE>() != std::string("FULL_PROFILE"))
        return "its driver has the embedded profile only";
    if (!device.getInfo<CL_DEVICE_ENDIAN_LITTLE>()) return "its byte order is big-endian";
    return "";
}

DeviceEntry describe(const cl::Device& device) {
    DeviceEntry entry;
    entry.name = device.getInfo<CL_DEVICE_NAME>();
    entry.kind = kind_of(device.getInfo<CL_DEVICE_TYPE>());
    entry.has_int64 = device.getInfo<CL_DEVICE_PROFILE>() == std::string("FULL_PROFILE");
    entry.has_fp64 = device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
    entry.memory_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    entry.largest_buffer_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    entry.unusable = why_unusable(device);
    return entry;
}

// A platform without a device gets an entry: its driver is installed, but does not work.
Found without_device(const std::string& platform, const std::string& reason) {
    Found found;
    found.entry.name = platform;
    found.entry.kind = "other";
    found.entry.unusable = reason;
    if (platform == "Portable Computing Language")
        found.entry.unusable +=
            "; PoCL says nothing when it cannot write its cache: set POCL_CACHE_DIR to a folder "
            "that can be written, or POCL_DEBUG=err to see more";
    return found;
}

std::vector<cl::Platform> find_platforms() {
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        platforms.clear();  // CL_PLATFORM_NOT_FOUND_KHR: no driver is installed
    }
    return platforms;
}

std::vector<DeviceEntry> entries_of(const std::vector<Found>& all) {
    std::vector<DeviceEntry> entries;
    entries.reserve(all.size());
    for (const Found& found : all) entries.push_back(found.entry);
    return entries;
}

std::vector<Found> find_devices() {
    const std::string forked = device::why_forked();
    if (!forked.empty()) return {without_device("OpenCL", forked)};
    // Drivers initialise themselves at the first call, and some cannot do it for several threads.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const std::string no_loader = why_no_loader();
    if (!no_loader.empty()) return {without_device("OpenCL", no_loader)};
    std::vector<Found> all;
    for (const cl::Platform& platform : find_platforms()) {
        std::string name = "an OpenCL platform";
        try {
            name = platform.getInfo<CL_PLATFORM_NAME>();
            std::vector<cl::Device> devices;
            platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
            for (const cl::Device& device : devices) all.push_back({describe(device), device});
            if (devices.empty()) all.push_back(without_device(name, "it lists no device"));
        } catch (const cl::Error& error) {
            const std::string reason =
                error.err() == CL_DEVICE_NOT_FOUND
                    ? "it lists no device"
                    : std::string(error.what()) + " failed with " + error_name(error.err());
            all.push_back(without_device(name, reason));
        }
    }
    return all;
}

}  // namespace

Found choose_device(const std::string& wanted) {
    const std::vector<Found> all = find_devices();
    return all[device::choose("opencl", entries_of(all), wanted)];
}

std::vector<DeviceEntry> list_devices() {
    return entries_of(find_devices());
}

}  // namespace lacuna::opencl
