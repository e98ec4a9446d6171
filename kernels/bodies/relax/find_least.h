// The body of find_least: finds the lower word of the least weight; its upper word is known.

// least[1] becomes 0xffffffff minus the lower word, so that ATOMIC_MAX finds the least.
BODY void serve_find_least(MEMORY const SiteArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.lattice.samples);
    const u32 upper = 0xffffffffu - LOOK_AT(least, 0u);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const u32x4 site = AT(sites, i);
        if (site.w != upper) continue;
        const u32 short_by = 0xffffffffu - site.z;
        if (LOOK_AT(least, 1u) < short_by) ATOMIC_MAX(least, 1u, short_by);
    }
}
