// The strips that split finds of places on unlike pixels. Comes after strip.h.

BODY Strip uneven_strip(MEMORY const u32 number, const u32 k) {
    const Strip strip = {AT(strips, number * 4u + k), AT(strip_radii, number * 4u + k)};
    return strip;
}
