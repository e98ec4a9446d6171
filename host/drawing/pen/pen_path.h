// A short way for a pen from dot to dot.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lacuna::pen {

// The indices of the points, each once, along an open path that is short: a greedy one improved by
// 2-opt and Or-opt until none of their moves between near points shortens it. Of random points it
// is 4 to 5 % longer than the shortest. The same points give the same path on every machine and any
// number of threads, in whatever order they come, but for its direction. Takes some 150 bytes a
// point. `may_go_on` is asked now and then; when it says no, throws Cancelled.
std::vector<std::uint32_t> pen_path(std::span<const Point> points,
                                    const std::function<bool()>& may_go_on);

// The order along Hilbert's space-filling curve: what a pen path is measured against.
std::vector<std::uint32_t> hilbert_order(std::span<const Point> points);

// The sum of the distances from each point to the next.
double path_length(std::span<const Point> points);

}  // namespace lacuna::pen
