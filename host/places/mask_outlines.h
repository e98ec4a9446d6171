// Masks as outlines, so that they can stand beside polygons.
#pragma once

#include <lacuna/places.h>
#include <lacuna/sample.h>

namespace lacuna::places {

// Places with outlines get those of the pixels where points may not lie, in place of their masks:
// for all points, or for each class if a class has a mask of its own. No border is kept from them.
// Masks without outlines stay as they are. Masks must be cut to the domain (cut_masks), and may not
// be drawn; there is none or one for each class, the same for all sizes of a kind. Throws
// BadRequest.
void turn_masks_into_outlines(const Domain& domain, const Classes& classes, Places& places);

}  // namespace lacuna::places
