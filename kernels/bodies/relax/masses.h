// The masses of lattice points: a word holds two pixels.
BODY u32 mass_of_pixel(MEMORY const u32 pixel) {
    return AT(masses, pixel / 2u) >> (pixel % 2u * 16u) & 0xffffu;
}
