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
struct LocateInBoxesArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t draw_count;
    std::uint32_t chunk;
};
struct SortColumnsArguments {
    std::uint32_t first_item;
    Geometry g;
};
struct ScreenArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t draw_count;
    std::uint32_t chunk;
};
struct AdmitArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t pass;
    std::uint32_t draw_count;
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
struct InsertArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t draw_count;
    std::uint32_t last_pass;
};
struct UnfoldArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t first_line;
    std::uint32_t end_line;
    std::uint32_t block;
    std::uint32_t is_counting;
};
struct CutArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t strip_count;
    std::uint32_t is_halved;
    std::uint32_t width;
    std::uint32_t last_pass;
};
struct KeepArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t strip_count;
    std::uint32_t is_halved;
    std::uint32_t width;
    std::uint32_t last_pass;
    std::uint32_t block;
    std::uint32_t room;
};
struct ScanArguments {
    std::uint32_t first_item;
    std::uint32_t value_count;
    std::uint32_t block;
};
struct FindPlaceBeginsArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t room;
};
static_assert(offsetof(LocateArguments, g) == 8 && sizeof(Geometry) == 64);
// What every device takes.
static_assert(sizeof(KeepArguments) <= 128 && sizeof(GrowArguments) <= 128);

struct Programs {
    Program locate;
    Program locate_in_boxes;
    Program sort_columns;
    Program screen;
    Program admit;
    Program gather;
    Program subtract;
    Program grow;
    Program insert;
    Program unfold;
    Program cut;
    Program keep;
    Program scan;
    Program find_place_begins;
};
Programs embedded_programs();

}  // namespace lacuna::vulkan
