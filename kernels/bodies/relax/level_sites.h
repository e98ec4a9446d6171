// The body of level_sites: builds a level of the tree over the sites.
#include "portable/power.h"
#include "portable/site_tree.h"

struct Node {
    u32x4 box;
    u64 weight;
};
LACUNA_TYPEDEF(Node)

// A node of the level below, or a site.
BODY Node child_of(MEMORY const SiteArguments a, const u32 i) {
    Node node;
    if (a.level == 1u) {
        const u32x4 site = AT(sites, i);
        node.box = U32X4(site.x, site.y, site.x, site.y);
        node.weight = join_words(site.z, site.w);
        return node;
    }
    const u32 at = a.level_begin * 8u + 1u + i;
    const u32x2 weight = AT(node_weights, at);
    node.box = AT(node_boxes, at);
    node.weight = join_words(weight.x, weight.y);
    return node;
}

BODY void serve_level_sites(MEMORY const SiteArguments a, const u32 item) {
    const u32 nodes = nodes_of_level(a.lattice.samples, a.level);
    const u32 below = nodes_of_level(a.lattice.samples, a.level - 1u);
    const u32 end_node = min((item + 1u) * a.chunk, nodes);
    for (u32 index = item * a.chunk; index < end_node; ++index) {
        const u32 end = min(index * 8u + 8u, below);
        Node all = child_of(ON a, index * 8u);
        for (u32 i = index * 8u + 1u; i < end; ++i) {
            const Node node = child_of(ON a, i);
            all.box = U32X4(min(all.box.x, node.box.x), min(all.box.y, node.box.y),
                            max(all.box.z, node.box.z), max(all.box.w, node.box.w));
            all.weight = node.weight < all.weight ? node.weight : all.weight;
        }
        AT(node_boxes, a.level_begin + index) = all.box;
        AT(node_weights, a.level_begin + index) =
            U32X2(to_u32(all.weight), to_u32(all.weight >> 32));
    }
}
