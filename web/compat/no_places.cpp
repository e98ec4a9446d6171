// Replaces host/places/resolve.cpp: the page and the npm package have no polygons, because drawing
// them would take room in the module that all visitors load.
#include <lacuna/sample.h>

namespace lacuna {

Resolved resolve(const Request& given) {
    if (!given.places.outlines.empty() || given.places.border_by_radius)
        throw BadRequest("inside", "given", "this module has no polygons");
    return {.request = given};
}

}  // namespace lacuna
