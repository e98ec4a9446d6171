// What no request and no claim may have of fields and masks. Each check throws BadRequest.
#pragma once

#include <lacuna/lacuna.h>

namespace lacuna {

// A field has a value for each pixel, all finite and at least 0. Returns whether one is above 0.
bool check_values(const Field& field);
// And one is above 0.
void check_importance(const Field& field);
// There are no stretches, or one for each pixel, all within limits.
void check_stretches(const Field& field);
// The field has no stretches, for `who`, which knows only disks.
void check_disks(const Field& field, const char* who);
// A mask has a value for each pixel; one that was drawn has been checked.
void check_mask(const Mask& mask);

}  // namespace lacuna
