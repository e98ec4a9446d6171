// OpenCL's error codes by name.
#include "backends/opencl/errors.h"

#include <CL/cl_ext.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace lacuna::opencl {
namespace {

// OpenCL has no call that returns the name. Here are the errors that calls in this folder can have.
#define NAME(code) \
    { code, #code }
constexpr std::pair<int, const char*> kNames[] = {
    NAME(CL_DEVICE_NOT_FOUND),
    NAME(CL_DEVICE_NOT_AVAILABLE),
    NAME(CL_COMPILER_NOT_AVAILABLE),
    NAME(CL_MEM_OBJECT_ALLOCATION_FAILURE),
    NAME(CL_OUT_OF_RESOURCES),
    NAME(CL_OUT_OF_HOST_MEMORY),
    NAME(CL_BUILD_PROGRAM_FAILURE),
    NAME(CL_MISALIGNED_SUB_BUFFER_OFFSET),
    NAME(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
    NAME(CL_INVALID_VALUE),
    NAME(CL_INVALID_DEVICE_TYPE),
    NAME(CL_INVALID_PLATFORM),
    NAME(CL_INVALID_DEVICE),
    NAME(CL_INVALID_CONTEXT),
    NAME(CL_INVALID_QUEUE_PROPERTIES),
    NAME(CL_INVALID_COMMAND_QUEUE),
    NAME(CL_INVALID_HOST_PTR),
    NAME(CL_INVALID_MEM_OBJECT),
    NAME(CL_INVALID_BUILD_OPTIONS),
    NAME(CL_INVALID_PROGRAM),
    NAME(CL_INVALID_PROGRAM_EXECUTABLE),
    NAME(CL_INVALID_KERNEL_NAME),
    NAME(CL_INVALID_KERNEL_DEFINITION),
    NAME(CL_INVALID_KERNEL),
    NAME(CL_INVALID_ARG_INDEX),
    NAME(CL_INVALID_ARG_VALUE),
    NAME(CL_INVALID_ARG_SIZE),
    NAME(CL_INVALID_KERNEL_ARGS),
    NAME(CL_INVALID_WORK_DIMENSION),
    NAME(CL_INVALID_WORK_GROUP_SIZE),
    NAME(CL_INVALID_WORK_ITEM_SIZE),
    NAME(CL_INVALID_GLOBAL_OFFSET),
    NAME(CL_INVALID_EVENT_WAIT_LIST),
    NAME(CL_INVALID_EVENT),
    NAME(CL_INVALID_OPERATION),
    NAME(CL_INVALID_BUFFER_SIZE),
    NAME(CL_INVALID_MIP_LEVEL),
    NAME(CL_INVALID_GLOBAL_WORK_SIZE),
    NAME(CL_INVALID_PROPERTY),
    NAME(CL_PLATFORM_NOT_FOUND_KHR),
};
#undef NAME

}  // namespace

std::string error_name(int code) {
    const std::string number = " (" + std::to_string(code) + ")";
    for (const auto& [known, name] : kNames)
        if (known == code) return name + number;
    return "OpenCL error" + number;
}

void Log::add(const char* message) {
    const std::lock_guard lock(mutex_);
    text_ += text_.empty() ? "" : "; ";
    text_ += message;
}

std::string Log::take() {
    const std::lock_guard lock(mutex_);
    std::string text = std::exchange(text_, {});
    // An error message is one line.
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

DeviceError device_error(const cl::Error& error, const std::string& device, Log& log) {
    const std::string said = log.take();
    return DeviceError("backend opencl, device " + device + ": " + error.what() + " failed with " +
                       error_name(error.err()) +
                       (said.empty() ? "" : "; the driver says: " + said));
}

}  // namespace lacuna::opencl
