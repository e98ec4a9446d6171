// 64-bit sums to which many items add, as two words each: the carry is added to the upper word.
#include "portable/power.h"

#define ADD_TO_SUM(sums, i, low, high)                                              \
    {                                                                               \
        const u32 carry = ATOMIC_ADD(sums, i, low) > 0xffffffffu - (low) ? 1u : 0u; \
        if ((high) + carry != 0u) ATOMIC_ADD(sums, (i) + 1u, (high) + carry);       \
    }

// Adds to a site's sums: its lattice points are counted in shares[4 site], its mass is in the two
// words from shares[4 site + 2], and its moments begin at moments[4 site].
BODY void add_to_share(MEMORY const u32 site, const u32 points, const u64 mass, const u64 moment_x,
                       const u64 moment_y) {
    ATOMIC_ADD(shares, site * 4u, points);
    ADD_TO_SUM(shares, site * 4u + 2u, to_u32(mass), to_u32(mass >> 32))
    ADD_TO_SUM(moments, site * 4u, to_u32(moment_x), to_u32(moment_x >> 32))
    ADD_TO_SUM(moments, site * 4u + 2u, to_u32(moment_y), to_u32(moment_y >> 32))
}
