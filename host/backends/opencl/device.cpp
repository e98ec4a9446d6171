// A device in use, and the compilation of its kernels.
#include "backends/opencl/device.h"

#include <lacuna/lacuna.h>

#include <new>

namespace lacuna::opencl {
namespace {

void CL_CALLBACK add_to_log(const char* message, const void*, std::size_t, void* log) {
    static_cast<Log*>(log)->add(message);
}

}  // namespace

void Turns::take() {
    std::unique_lock lock(mutex_);
    is_free_.wait(lock, [&] { return !is_taken_; });
    is_taken_ = true;
}

void Turns::give_back() noexcept {
    {
        const std::lock_guard lock(mutex_);
        is_taken_ = false;
    }
    is_free_.notify_one();
}

Device::Device(const Found& found) : entry_(found.entry), device_(found.device) {
    guard([&] { context_ = cl::Context(device_, nullptr, add_to_log, static_cast<void*>(&log_)); });
}

cl::Program Device::compiled(std::string_view source) {
    const std::lock_guard lock(mutex_);
    const auto found = programs_.find(source);
    if (found != programs_.end()) return found->second;
    return guard([&] {
        auto program = std::make_unique<cl::Program>(context_, std::string(source));
        // See kernels/bodies/common/dialect.h.
        const char* const options =
            is_oclgrind() ? "-cl-std=CL1.2 -DLACUNA_ATOMIC_LOOKS" : "-cl-std=CL1.2";
        try {
            program->build(device_, options);
        } catch (const cl::BuildError& error) {
            for (const auto& [device, text] : error.getBuildLog()) log_.add(text.c_str());
            throw;
        } catch (const std::bad_alloc&) {
            // The exception passed through the driver, which still holds its lock of the program.
            // Releasing the program, or counting one more use of it, would wait for ever.
            static_cast<void>(program.release());
            throw DeviceError("backend opencl, device " + entry_.name +
                              ": out of memory while kernels were built");
        }
        return programs_.emplace(source, *program).first->second;
    });
}

std::shared_ptr<Device> kept_device(const std::string& wanted) {
    static std::mutex mutex;
    // Never destroyed: by the end of the process a driver may have destroyed itself.
    using All = std::map<cl_device_id, std::shared_ptr<Device>>;
    static All& all = *std::make_unique<All>().release();
    const Found found = choose_device(wanted);
    const std::lock_guard lock(mutex);
    std::shared_ptr<Device>& device = all[found.device()];
    if (device == nullptr) device = std::make_shared<Device>(found);
    return device;
}

std::string_view source_of(std::string_view kernel, std::span<const std::string_view> sources) {
    const std::string entry = "\nKERNEL(" + std::string(kernel) + ",";
    for (const std::string_view source : sources)
        if (source.find(entry) != std::string_view::npos) return source;
    return {};
}

}  // namespace lacuna::opencl
