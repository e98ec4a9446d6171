// The compute shaders, embedded. The headers are made by cmake/vulkan.cmake.
#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "backends/vulkan/device.h"
#include "portable/kernels.h"

namespace lacuna::vulkan {
namespace {

#include "admit.spv.h"
#include "admit_in_cells.spv.h"
#include "cut.spv.h"
#include "find_least.spv.h"
#include "find_place_begins.spv.h"
#include "find_rivals.spv.h"
#include "gather.spv.h"
#include "gather_shares.spv.h"
#include "grow.spv.h"
#include "insert.spv.h"
#include "keep.spv.h"
#include "level_sites.spv.h"
#include "locate.spv.h"
#include "locate_in_boxes.spv.h"
#include "locate_in_cells.spv.h"
#include "look_up_radii.spv.h"
#include "own.spv.h"
#include "own_crowded.spv.h"
#include "scan.spv.h"
#include "screen.spv.h"
#include "settle.spv.h"
#include "sort_columns.spv.h"
#include "subtract.spv.h"
#include "subtract_in_cells.spv.h"
#include "unfold.spv.h"

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
