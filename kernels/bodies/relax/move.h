// The body of move: a site moves towards its centre of mass, and its weight follows its mass.
#include "bodies/relax/site.h"
#include "portable/site_tree.h"

BODY void move_site(MEMORY const SiteArguments a, const u32 i) {
    Site site = LOAD(Site, sites, i);
    const u64 mass = join_words(AT(shares, 4u * i + 2u), AT(shares, 4u * i + 3u));
    const u32 below =
        AT(masses, site.y / a.lattice.step_y / a.lattice.cut_y * a.lattice.pixel_columns +
                       site.x / a.lattice.step_x / a.lattice.cut_x);
    if (!stays(mass, below)) {
        const u32 x =
            centre_of_mass(join_words(AT(moments, 4u * i), AT(moments, 4u * i + 1u)), mass, site.x,
                           a.lattice.step_x, a.lattice.columns, a.lattice.period_x);
        const u32 y =
            centre_of_mass(join_words(AT(moments, 4u * i + 2u), AT(moments, 4u * i + 3u)), mass,
                           site.y, a.lattice.step_y, a.lattice.rows, a.lattice.period_y);
        site.x =
            moved_place(site.x, x, a.way, a.lattice.columns * a.lattice.step_x, a.lattice.period_x);
        site.y =
            moved_place(site.y, y, a.way, a.lattice.rows * a.lattice.step_y, a.lattice.period_y);
    }
    const u64 weight = moved_weight(a.lattice, weight_of(site), mass, AT(shares, 4u * i));
    STORE(sites, i, with_weight(site, weight));
}

BODY void serve_move(MEMORY const SiteArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.lattice.samples);
    for (u32 i = item * a.chunk; i < end; ++i) move_site(ON a, i);
}
