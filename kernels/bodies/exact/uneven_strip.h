// The strips that split finds of place uneven[i]. Comes after strip.h.

BODY Strip uneven_strip(MEMORY const u32 i, const u32 k) {
    const Strip strip = {AT(strips, i * 4u + k), AT(strip_radii, i * 4u + k)};
    return strip;
}
