// The compute shaders, embedded.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace lacuna::vulkan {

// The SPIR-V words of the shader that cmake/vulkan.cmake compiled for the kernel.
std::span<const std::uint32_t> embedded_shader(std::string_view kernel);

}  // namespace lacuna::vulkan
