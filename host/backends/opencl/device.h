// The OpenCL devices of this machine; the device in use and its compiled kernels: one for the
// process, which all backends use.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backends/device/choice.h"
#include "backends/device/queue.h"
#include "backends/opencl/cl.h"
#include "backends/opencl/errors.h"

namespace lacuna::opencl {

// The device is null for the entry of a platform that has none.
struct Found {
    DeviceEntry entry;
    cl::Device device;
};

// The device that a request names, see device::choose. Throws Unavailable.
Found choose_device(const std::string& wanted);

// At most one queue at a time, the one that has the turn, may have kernels under way. PoCL (3.1 and
// others) compiles a kernel into one binary for small grids and one for large ones. When a kernel
// is done, PoCL counts down the uses of the first binary that it finds. That may be the wrong one
// where queues use both, and then an assertion ends the process.
class Turns {
public:
    // Waits until no queue has the turn.
    void take();
    void give_back() noexcept;

private:
    std::mutex mutex_;
    std::condition_variable is_free_;
    bool is_taken_ = false;
};

class Device {
public:
    explicit Device(const Found& found);

    const DeviceEntry& entry() const { return entry_; }
    bool is_oclgrind() const { return entry_.name.find("Oclgrind") != std::string::npos; }
    const cl::Device& device() const { return device_; }
    const cl::Context& context() const { return context_; }
    Turns& turns() { return turns_; }
    const std::shared_ptr<device::HostMemoryPool>& host_memory() const { return host_memory_; }

    // Compiles the source at its first use. Throws DeviceError with the build log.
    cl::Program compiled(std::string_view source);

    // Calls work(); OpenCL's errors become Lacuna's.
    template <typename Work>
    auto guard(Work work) {
        return guarded(entry_.name, log_, work);
    }

private:
    DeviceEntry entry_;
    Log log_;  // before the context, whose driver writes to it
    cl::Device device_;
    cl::Context context_;
    Turns turns_;
    std::shared_ptr<device::HostMemoryPool> host_memory_ =
        std::make_shared<device::HostMemoryPool>();
    std::mutex mutex_;
    std::map<std::string, cl::Program, std::less<>> programs_;
};

// The device that a request names, opened once for the process. Throws Unavailable.
std::shared_ptr<Device> kept_device(const std::string& wanted);

// The files of kernels/, includes expanded, in groups that are compiled together; and the first
// source that has the KERNEL, empty if there is none.
std::span<const std::string_view> kernel_sources();
std::string_view source_of(std::string_view kernel, std::span<const std::string_view> sources);

// The queue of one backend on the device. A kernel is compiled when it is first launched: from the
// first of `sources` that has it, else from kernel_sources().
std::unique_ptr<device::Queue> make_queue(std::shared_ptr<Device> device,
                                          const std::vector<std::string>& sources);

}  // namespace lacuna::opencl
