// The blur of pictures.
#pragma once

#include <cstddef>
#include <span>

namespace lacuna::pictures {

// Replaces each value by the mean of those up to `radius` pixels away in its row, then in its
// column; three times. That is nearly a Gaussian blur, and the same on every machine. Beyond an
// edge the value at the edge counts.
void blur(std::span<double> values, std::size_t columns, std::size_t rows, std::size_t radius);

}  // namespace lacuna::pictures
