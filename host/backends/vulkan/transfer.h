// Tables on their way between host and device.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "backends/vulkan/engine.h"

namespace lacuna::vulkan {

inline constexpr std::uint64_t kWord = sizeof(std::uint32_t);

inline Buffer on_device(Engine& engine, std::uint64_t bytes) {
    return engine.allocate(Engine::Memory::device, bytes);
}

inline Buffer words_on_device(Engine& engine, std::uint64_t words) {
    return on_device(engine, words * kWord);
}

// Memory of the host, as large as the buffer, to copy it from or to.
inline Buffer host_copy_of(Engine& engine, const Buffer& buffer, Engine::Memory memory) {
    return engine.allocate(memory, buffer.bytes());
}

template <typename T>
void put(const std::vector<T>& values, const Buffer& staging) {
    std::memcpy(staging.as<T>().data(), values.data(), values.size() * sizeof(T));
}

// Recorded, through memory of its own: for what happens seldom.
template <typename T>
void write(Engine& engine, const Buffer& to, std::span<const T> values) {
    const Buffer staging = engine.allocate(Engine::Memory::upload, values.size_bytes());
    if (!values.empty()) std::memcpy(staging.as<T>().data(), values.data(), values.size_bytes());
    engine.copy(staging, to, values.size_bytes());
}

// Waits for what is recorded, too.
template <typename T>
std::vector<T> read(Engine& engine, const Buffer& from, std::size_t count) {
    const Buffer staging = engine.allocate(Engine::Memory::download, count * sizeof(T));
    engine.copy(from, staging, count * sizeof(T));
    engine.wait();
    const std::span<T> values = staging.as<T>().first(count);
    return {values.begin(), values.end()};
}

}  // namespace lacuna::vulkan
