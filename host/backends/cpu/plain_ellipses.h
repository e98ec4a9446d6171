// The inner loops over samples with ellipses in plain C++ (vectors.h). They are in a file of their
// own, which the page's module leaves out.
#pragma once

#include <cstddef>
#include <cstdint>

#include "backends/cpu/vectors.h"

namespace lacuna::cpu::plain {

std::size_t next_in_ellipse(const SizedSpan& samples, Sample at, const FloatEllipse& e,
                            std::size_t from);
std::uint32_t find_touching_ellipses(const SizedSpan& samples, const FloatEllipse* of_samples,
                                     const Box* boxes, const FloatEllipse* of_boxes,
                                     std::uint8_t* touching);

}  // namespace lacuna::cpu::plain
