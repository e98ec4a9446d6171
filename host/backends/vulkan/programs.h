// The compute shaders (shaders/*.comp), compiled at build time, and the arguments they take.
#pragma once

#include <cstdint>

#include "backends/vulkan/engine.h"
#include "portable/geometry.h"

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
// Those of mode cells: of a line so many words, of a column of pixels so many rows.
struct LocateInCellsArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t words;
    std::uint32_t draw_count;
    std::uint32_t chunk;
};
struct LookUpRadiiArguments {
    std::uint32_t first_item;
    std::uint32_t rows;
    std::uint32_t draw_count;
};
struct AdmitInCellsArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t rows;
    std::uint32_t metric;
    std::uint32_t pass;
    std::uint32_t draw_count;
    std::uint32_t chunk;
};
struct SubtractInCellsArguments {
    std::uint32_t first_item;
    Geometry g;
    std::uint32_t words;
    std::uint32_t rows;
    std::uint32_t metric;
    std::uint32_t last_pass;
    std::uint32_t count;
    std::uint32_t slices;
    std::uint32_t most_reach;
    std::uint32_t is_listed;
};
static_assert(offsetof(LocateArguments, g) == 8 && sizeof(Geometry) == 64);
// What every device takes.
static_assert(sizeof(KeepArguments) <= 128 && sizeof(GrowArguments) <= 128 &&
              sizeof(SubtractInCellsArguments) <= 128);

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
    Program locate_in_cells;
    Program look_up_radii;
    Program admit_in_cells;
    Program subtract_in_cells;
};
Programs embedded_programs();

}  // namespace lacuna::vulkan
