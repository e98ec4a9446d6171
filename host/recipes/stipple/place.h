// Places the dots of a picture and moves them.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <span>

#include "recipes/make.h"

namespace lacuna::recipes {

// Makes the dots of a request that has a field, or those of its inks if there are some. Dots that
// `start` holds, if there are any, are moved on, and each keeps its index.
//
// Dots that are relaxed in the picture alone lie in rows along its edges: the first quarter of a
// spacing is empty, and the next one has two and a half times its share. Open edges have dots on
// either side: in mode stratified the picture gets a margin of four mean spacings, in which it is
// mirrored and has dots as well, and these are taken away in the end. A torus has no edges, and
// they stay closed where the margin would double the area, as with fewer than about 370 dots.
// Made::relaxed is about the dots of picture and margin.
enum class Edges { open, closed };
Made place_dots(const Request& request, std::span<const InkPart> inks, std::span<const Point> start,
                const Moves& moves, Edges edges, Observer& observer);

}  // namespace lacuna::recipes
