// The compute shaders (shaders/*.comp), compiled at build time, and the arguments they take.
#pragma once

#include <cstdint>

#include "portable/geometry.h"
#include "vulkan/engine.h"

namespace lacuna::vulkan {

using portable::Geometry;

// As the shaders' push constants lay them out. The engine fills in first_item.
struct LocateArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t first_line;
    std::uint32_t first_draw;
    std::uint32_t end_draw;
    std::uint32_t chunk;
};
struct SortColumnsArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t draws;
    std::uint32_t chunk;
};
struct AdmitArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t pass;
    std::uint32_t draws;
    std::uint32_t chunk;
};
struct GatherArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t last_pass;
};
struct SubtractArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t first_line;
    std::uint32_t end_line;
    std::uint32_t last_pass;
};
struct GrowArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t from_line;
    std::uint32_t to_line;
    std::uint32_t first_line;
    std::uint32_t end_line;
    std::uint32_t larger;
};
static_assert(offsetof(LocateArguments, g) == 8 && sizeof(Geometry) == 40);

struct Programs {
    Program locate;
    Program sort_columns;
    Program admit;
    Program gather;
    Program subtract;
    Program grow;
};

Programs embedded_programs();

}  // namespace lacuna::vulkan
