// From a picture to importance: section 4.2's field I, dark is dense.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/pictures.h>

#include "pictures/image.h"

namespace lacuna::pictures {

using Importance = lacuna::Tone;

// Throws BadRequest if a value is not allowed; what importance_of() checks, without a picture.
void check(const Importance& options);

// I = max(min_importance, d^gamma), where d = 1 - l, or l with invert, and l is luminance / white
// of the picture, stretched from black to white of the options. So every value lies in [0, 1], and
// white (black with invert) stays 0, which means no sample there, unless min_importance is over 0.
// With gamma 1 the result is the same to the last bit on every machine; other powers are those of
// the C library's pow. Takes the picture's memory. Throws BadRequest as above, or where gamma
// rounds all importance to 0, and FileError naming the picture if no pixel has any importance.
Field importance_of(Image image, const Importance& options);

}  // namespace lacuna::pictures
