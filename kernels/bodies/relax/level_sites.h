// The body of level_sites: builds a level of the tree over the sites.
#include "bodies/relax/site.h"
#include "portable/site_tree.h"

// What child i of a node has: a node of the level below, or a site.
BODY Bounds bounds_of_child(MEMORY const SiteArguments a, const u32 i) {
    if (a.level == 1u) return bounds_of(LOAD(Site, sites, i));
    return LOAD(Bounds, node_boxes, a.level_begin * 8u + 1u + i);
}

BODY u64 weight_of_child(MEMORY const SiteArguments a, const u32 i) {
    if (a.level == 1u) return weight_of(LOAD(Site, sites, i));
    return number_of(LOAD(Wide, node_weights, a.level_begin * 8u + 1u + i));
}

BODY void serve_level_sites(MEMORY const SiteArguments a, const u32 item) {
    const u32 nodes = nodes_of_level(a.lattice.samples, a.level);
    const u32 below = nodes_of_level(a.lattice.samples, a.level - 1u);
    const u32 end_node = min((item + 1u) * a.chunk, nodes);
    for (u32 index = item * a.chunk; index < end_node; ++index) {
        const u32 end = min(index * 8u + 8u, below);
        Bounds box = bounds_of_child(ON a, index * 8u);
        u64 least = weight_of_child(ON a, index * 8u);
        for (u32 i = index * 8u + 1u; i < end; ++i) {
            const Bounds child = bounds_of_child(ON a, i);
            const u64 weight = weight_of_child(ON a, i);
            box.low_x = min(box.low_x, child.low_x);
            box.low_y = min(box.low_y, child.low_y);
            box.high_x = max(box.high_x, child.high_x);
            box.high_y = max(box.high_y, child.high_y);
            least = weight < least ? weight : least;
        }
        STORE(node_boxes, a.level_begin + index, box);
        STORE(node_weights, a.level_begin + index, wide_of(least));
    }
}
