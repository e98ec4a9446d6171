// OpenCL's error codes by name, and its errors turned into Lacuna's.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <mutex>
#include <string>

#include "backends/opencl/cl.h"

namespace lacuna::opencl {

// "CL_OUT_OF_RESOURCES (-5)".
std::string error_name(int code);

// The messages of a context's driver, which may come from any of its threads.
class Log {
public:
    void add(const char* message);
    // Returns and removes all messages.
    std::string take();

private:
    std::mutex mutex_;
    std::string text_;
};

// Names the call, the error, the device and the driver's log, in one line.
DeviceError device_error(const cl::Error& error, const std::string& device, Log& log);

// Calls work(); OpenCL's errors become Lacuna's.
template <typename Work>
auto guarded(const std::string& device, Log& log, Work work) {
    try {
        return work();
    } catch (const cl::Error& error) {
        throw device_error(error, device, log);
    }
}

}  // namespace lacuna::opencl
