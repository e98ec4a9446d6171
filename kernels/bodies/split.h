// The body of split: halves the places of a ground along x, and cuts halves along y where a border
// of pixels runs through them: four strips a place. Comes after ground.h.

// One that is not there, or where no sample may go, is empty: then its radius is 0.
BODY void put_strip(MEMORY const u32 number, const u32x4 at, const u32 first, const u32 radius) {
    AT(strips, number) = U32X4(at.x, at.y, radius != 0u ? at.z : 0u, radius != 0u ? at.w : 0u);
    AT(strip_origins, number) = U32X2(first, radius);
}

BODY void put_half(MEMORY const u32 number, const u32x4 part, const u32 first,
                   const u32 even_radius) {
    u32 up = 0u;
    u32x2 radii = U32X2(even_radius, 0u);  // below the cut along y, and above
    if (even_radius == 0u) {
        const Under all = under(ON part);
        up = cut_y(ON part, all);
        radii.x = all.least;
    }
    u32x4 low = part;
    u32x4 high = part;
    if (up != 0u) {
        low.w = up;
        high.z = up;
        radii = U32X2(under(ON low).least, under(ON high).least);
    }
    put_strip(ON number, low, first, radii.x);
    put_strip(ON number + 1u, high, first, radii.y);
}

BODY void serve_split(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x4 place = AT(places, number);
        const u32 first = AT(origins, number).x;
        const u32 even_radius = AT(lists, first).y;
        u32 cut = place.y > 1u ? place.x + place.y / 2u : 0u;
        if (even_radius == 0u) cut = cut_x(ON place, under(ON place));
        for (u32 half_number = 0u; half_number < 2u; ++half_number) {
            u32x4 part = place;
            if (half_number == 1u)
                part = U32X4(cut, place.x + place.y - cut, place.z, place.w);
            else if (cut != 0u)
                part.y = cut - place.x;
            const u32 to = number * 4u + half_number * 2u;
            if (half_number == 0u || cut != 0u) {
                put_half(ON to, part, first, even_radius);
            } else {
                put_strip(ON to, part, first, 0u);
                put_strip(ON to + 1u, part, first, 0u);
            }
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}
