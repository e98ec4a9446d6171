// A short path for a pen from dot to dot.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lacuna::pen {

// The indices of the points, each once, along a short open path: a greedy one, improved by 2-opt
// and Or-opt between near points. No two segments of the path cross: none have a point in common
// that is an end of neither, unless they lie on one line. No segment longer than ten times the mean
// could be exchanged together with another one to shorten the path. Both hold for the points as
// rounded to 2^-25 of their longer side. For random points it is 3.5 % longer than the shortest
// path. Except for its direction the path does not depend on the machine, the number of threads or
// the order of the points. It takes about 160 bytes a point. `may_go_on` is called now and then; if
// it returns false, Cancelled is thrown.
std::vector<std::uint32_t> pen_path(std::span<const Point> points,
                                    const std::function<bool()>& may_go_on);

// The order along Hilbert's space-filling curve, with which pen paths are compared.
std::vector<std::uint32_t> hilbert_order(std::span<const Point> points);

// The sum of the distances from each point to the next.
double path_length(std::span<const Point> points);

}  // namespace lacuna::pen
