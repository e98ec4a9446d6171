// Places the dots of a picture and moves them.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <span>

#include "options/make.h"

namespace lacuna::stippling {

// Makes the dots of a request that has a field, or those of its inks if there are some. Dots that
// `start` holds, if there are any, are moved on, and each keeps its index.
//
// Dots that are relaxed in the picture alone lie in rows along its edges: the first quarter of a
// spacing is empty, and the next one has two and a half times its share. Open edges have dots on
// either side: in mode stratified the picture gets a margin, in which it is mirrored and has dots
// as well, and these are taken away in the end. The margin is four spacings of dots along the
// lightest side, but not larger than the picture. There is none on a torus, for fewer than some 25
// dots, and for more than 10 million. Made::relaxed is about the dots of picture and margin.
enum class Edges { open, closed };
options::Made place_dots(const Request& request, std::span<const InkPart> inks,
                         std::span<const Point> start, const options::Moves& moves, Edges edges,
                         Observer& observer);

}  // namespace lacuna::stippling
