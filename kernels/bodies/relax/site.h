// Sites and their weights, which elements have in two words.
#ifndef LACUNA_BODIES_SITE_H
#define LACUNA_BODIES_SITE_H
#include "portable/site_tree.h"

BODY u64 number_of(const Wide wide) {
    return join_words(wide.low, wide.high);
}

BODY Wide wide_of(const u64 number) {
    const Wide wide = {to_u32(number), to_u32(number >> 32)};
    return wide;
}

BODY u64 weight_of(const Site site) {
    return join_words(site.weight_low, site.weight_high);
}

BODY Site with_weight(const Site site, const u64 weight) {
    const Site same = {site.x, site.y, to_u32(weight), to_u32(weight >> 32)};
    return same;
}

BODY Bounds bounds_of(const Site site) {
    const Bounds bounds = {site.x, site.y, site.x, site.y};
    return bounds;
}

#endif
