// The kernels of portable/kernels.h as the host launches them: a type for each, by its name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "backends/device/queue.h"
#include "portable/kernels.h"

namespace lacuna::device {

// Every buffer that some kernel names. A launch binds the buffers of its kernel by their names.
struct Memory {
#define LACUNA_BUFFER(type, name) Buffer name;
    LACUNA_BUFFERS(LACUNA_BUFFER)
#undef LACUNA_BUFFER
};

inline constexpr std::size_t kMostBuffers = 16;     // of a kernel: many devices allow no more
inline constexpr std::size_t kMostArguments = 128;  // bytes: every Vulkan device allows these

template <std::size_t count>
constexpr bool are_in_order(const std::array<std::uint32_t, count>& numbers) {
    for (std::uint32_t i = 0; i < count; ++i)
        if (numbers[i] != i) return false;
    return count <= kMostBuffers;
}

namespace kernels {

#define LACUNA_NUMBER(number, access, type, name) number,
#define LACUNA_FROM_MEMORY(number, access, type, name) memory.name,
#define LACUNA_KERNEL(kernel, TheArguments, BINDINGS)                                      \
    struct kernel {                                                                        \
        using Arguments = portable::TheArguments;                                          \
        static constexpr std::array<                                                       \
            std::uint32_t, 0 + std::initializer_list<int>{BINDINGS(LACUNA_NUMBER)}.size()> \
            numbers{BINDINGS(LACUNA_NUMBER)};                                              \
        static_assert(are_in_order(numbers));                                              \
        static_assert(offsetof(Arguments, first_item) == 0);                               \
        static_assert(sizeof(Arguments) <= kMostArguments);                                \
        static constexpr KernelShape shape{#kernel, numbers.size(), sizeof(Arguments)};    \
        static std::array<Buffer, numbers.size()> of(const Memory& memory) {               \
            return {BINDINGS(LACUNA_FROM_MEMORY)};                                         \
        }                                                                                  \
    };
LACUNA_KERNELS(LACUNA_KERNEL)
#undef LACUNA_KERNEL
#undef LACUNA_FROM_MEMORY
#undef LACUNA_NUMBER

inline constexpr std::array kAll{
#define LACUNA_SHAPE(kernel, Arguments, BINDINGS) kernel::shape,
    LACUNA_KERNELS(LACUNA_SHAPE)
#undef LACUNA_SHAPE
};

}  // namespace kernels

// GLSL and OpenCL C lay these out as C++ does: 8-byte words first, padding only at the end.
static_assert(sizeof(portable::Geometry) == 72 && offsetof(portable::DrawArguments, g) == 8 &&
              offsetof(portable::SlabArguments, g) == 8 &&
              offsetof(portable::StripArguments, g) == 8 &&
              offsetof(portable::ColumnArguments, g) == 8);
static_assert(offsetof(portable::DrawArguments, first) == 80 &&
              offsetof(portable::DrawArguments, room) == 120 &&
              offsetof(portable::SlabArguments, tile_height) == 124 &&
              offsetof(portable::StripArguments, least_to_split) == 112 &&
              offsetof(portable::ColumnArguments, room) == 80);

template <typename Kernel>
void launch(Queue& queue, const Memory& memory, typename Kernel::Arguments arguments,
            std::uint64_t items, std::uint64_t work = 1) {
    queue.launch(Kernel::shape, std::as_writable_bytes(std::span(&arguments, 1)),
                 Kernel::of(memory), items, work);
}

}  // namespace lacuna::device
