// The lengths of a pen's strokes.
#pragma once

#include <lacuna/lacuna.h>

#include <span>

namespace lacuna::stippling {

// Makes strokes shorter or longer until they cover about as much of the paper as the importance
// asks for, near each of them: strokes lie as they like, and cross. `reaches` are about the
// distances from each stroke to its neighbours. A stroke is 2 a long and 2 b wide; it stays at
// least as long as it is wide, and becomes at most half as long again.
void fit_strokes(std::span<const Point> middles, std::span<Ellipse> strokes,
                 std::span<const double> reaches, const Field& field, const Domain& domain);

}  // namespace lacuna::stippling
