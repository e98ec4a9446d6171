// A Vulkan device at work: buffers, kernels, and a queue of commands. All of Vulkan stays behind
// this header.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "backends/device/choice.h"
#include "backends/vulkan/validation.h"

namespace lacuna::vulkan {

// What a kernel may have.
inline constexpr std::uint32_t kMostBuffers = 16;

// Memory on the device, or memory of the host that the device copies from and to. Copies of a
// Buffer mean the same memory; the queue holds on to what its commands still need.
class Buffer {
public:
    std::uint64_t bytes() const { return bytes_; }
    // What the host sees of it; empty for memory on the device.
    template <typename T>
    std::span<T> as() const {
        static_assert(std::is_trivially_copyable_v<T>);
        return {static_cast<T*>(mapped_), mapped_ == nullptr ? 0 : bytes_ / sizeof(T)};
    }

private:
    friend class Engine;
    struct Handles;
    std::shared_ptr<Handles> handles_;
    void* mapped_ = nullptr;
    std::uint64_t bytes_ = 0;
};

// A compute shader. Its first specialisation constant is the size of a work group; its buffers
// are bindings 0, 1, ..., at most kMostBuffers; its push constants begin with the number of the
// first item to serve.
struct Program {
    std::string_view name;
    std::span<const std::uint32_t> spirv;
    std::uint32_t buffers;
    std::uint32_t argument_bytes;
};

class Kernel {
    friend class Engine;
    struct Handles;
    std::shared_ptr<Handles> handles_;
};

// All calls throw DeviceError, which names the device, the Vulkan call and its result.
class Engine {
public:
    enum class Memory { device, upload, download };

    // Throws Unavailable when there is no such device. Keeps the validation's address.
    Engine(std::string_view wanted_device, const Validation* validation);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    const DeviceEntry& device() const;
    Buffer allocate(Memory memory, std::uint64_t bytes);
    Kernel make_kernel(const Program& program);

    // Asked before each submission; false discards what is recorded and throws Cancelled.
    void watch(std::function<bool()> may_go_on);

    // Commands. They run at wait(), or earlier where dispatches add up to much work, in order, but
    // for what a barrier() keeps apart side by side.
    void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes,
              std::uint64_t from_offset = 0, std::uint64_t to_offset = 0);
    void fill(const Buffer& buffer, std::uint32_t value, std::uint64_t bytes,
              std::uint64_t offset = 0);
    void barrier();
    // Serves items [0, items), in several dispatches if they are many. `work` is about how many
    // steps of a tenth of a microsecond an item takes.
    template <typename Arguments>
    void dispatch(const Kernel& kernel, std::initializer_list<Buffer> buffers,
                  const Arguments& arguments, std::uint32_t items, std::uint32_t work = 1) {
        static_assert(std::is_trivially_copyable_v<Arguments>);
        static_assert(offsetof(Arguments, first_item) == 0);
        dispatch_bytes(kernel, buffers, std::as_bytes(std::span(&arguments, 1)), items, work);
    }
    void wait();

    // How many dispatches have been recorded. For tests.
    std::uint64_t dispatches() const;

private:
    struct Impl;
    void dispatch_bytes(const Kernel& kernel, std::initializer_list<Buffer> buffers,
                        std::span<const std::byte> arguments, std::uint32_t items,
                        std::uint32_t work);

    std::unique_ptr<Impl> impl_;
};

}  // namespace lacuna::vulkan
