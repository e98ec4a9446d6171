// The masses of lattice points: two pixels a word.
BODY u32 mass_of_pixel(MEMORY const u32 pixel) {
    return AT(masses, pixel / 2u) >> (pixel % 2u * 16u) & 0xffffu;
}
