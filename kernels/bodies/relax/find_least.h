// The body of find_least: the lower word of the least weight, once its upper one is known.

// least[1] becomes what it is short of its greatest value.
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
