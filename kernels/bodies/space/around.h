// The blocks around a block: those whose samples may be closer than the radius to a spot of it, as
// FirstBins::for_each_near of the host finds them (space/first_bins.h).
#include "portable/space.h"

// The words of volume[]: its sides in units, how many cells each side is cut into, and whether it
// is a torus. On a surface all are 0.
#define VOLUME_SIDES 0u
#define VOLUME_CELLS 3u
#define VOLUME_WRAPS 6u

struct Around {
    bool is_volume;
    u32 begin;  // on a surface: the first entry of near_blocks[]
    u32 count;
    // In a volume.
    Position sides;
    Position cells;
    bool wraps;
    Position place;  // of the block among the cells
};
LACUNA_TYPEDEF(Around)

BODY Position position_in_volume(MEMORY const u32 word) {
    const Position position = {to_i32(AT(volume, word)), to_i32(AT(volume, word + 1u)),
                               to_i32(AT(volume, word + 2u))};
    return position;
}

BODY Around blocks_around(MEMORY const u32 block) {
    Around around;
    around.sides = position_in_volume(ON VOLUME_SIDES);
    around.cells = position_in_volume(ON VOLUME_CELLS);
    around.wraps = AT(volume, VOLUME_WRAPS) != 0u;
    around.is_volume = around.sides.x != 0;
    around.place = around.sides;
    around.begin = 0u;
    around.count = NEAR_CELLS;
    if (around.is_volume) {
        around.place = place_of_cell(around.cells, block);
    } else {
        around.begin = AT(near_begins, block);
        around.count = AT(near_begins, block + 1u) - around.begin;
    }
    return around;
}

BODY NearCell block_around(MEMORY const Around around, const u32 which) {
    if (around.is_volume)
        return near_cell(around.sides, around.cells, around.wraps, around.place, which);
    NearCell near;
    near.exists = true;
    near.number = AT(near_blocks, around.begin + which);
    near.shift.x = 0;
    near.shift.y = 0;
    near.shift.z = 0;
    return near;
}

BODY Position listed_at(const Listed one, const NearCell near) {
    const Position at = {one.x, one.y, one.z};
    return moved(at, near.shift);
}
