// The rivals of a unit, seen from one of its leaves.

// The position of a leaf in its unit: `right` and `up` are in lattice points.
struct Place {
    u32 slot;   // index of the unit's first rival
    u32 count;  // number of rivals
    i32 right;
    i32 up;
};
LACUNA_TYPEDEF(Place)

// The lag of a rival in the leaf; see Lag.
struct Near {
    i32 at;
    i32 along_x;
    i32 along_y;
    u32 order;
};
LACUNA_TYPEDEF(Near)

BODY Near near_at(MEMORY const Place place, const u32 i) {
    const ShortLag rival = LOAD(ShortLag, rivals, place.slot + i);
    Near near;
    near.along_x = rival.along_x;
    near.along_y = rival.along_y;
    near.at = rival.at + place.right * rival.along_x + place.up * rival.along_y;
    near.order = rival.order;
    return near;
}

BODY Place place_of(MEMORY const Area unit, const Area leaf, const u32 index) {
    Place place;
    place.slot = index * RIVAL_ROOM;
    place.count = AT(rival_counts, index);
    place.right = to_i32(leaf.left - unit.left);
    place.up = to_i32(leaf.bottom - unit.bottom);
    return place;
}
