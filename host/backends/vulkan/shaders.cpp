// The compute shaders, embedded. The headers are made by cmake/vulkan.cmake.
#include "backends/vulkan/shaders.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "portable/kernels.h"

namespace lacuna::vulkan {
namespace {

#include "all_shaders.h"

#define LACUNA_SHADER(kernel, Arguments, BINDINGS) {#kernel, kernel##_spirv},
const std::pair<std::string_view, std::span<const std::uint32_t>> kShaders[] = {
    LACUNA_KERNELS(LACUNA_SHADER)};
#undef LACUNA_SHADER

}  // namespace

std::span<const std::uint32_t> embedded_shader(std::string_view kernel) {
    for (const auto& [name, words] : kShaders)
        if (name == kernel) return words;
    throw std::logic_error("no shader is called " + std::string(kernel));
}

}  // namespace lacuna::vulkan
