// What rings of a file or an array enclose, as rings of the even-odd rule.
#pragma once

#include <lacuna/domains.h>

#include <vector>

namespace lacuna::domains {

// The first ring, the shell, less the union of the others, its holes, wherever these lie. Rings
// that neither overlap nor leave the shell are returned as they are given. All coordinates must be
// fair. joined() of lacuna/domains.h has the other rule.
std::vector<PolygonRing> shell_less_holes(std::vector<PolygonRing> rings);

}  // namespace lacuna::domains
