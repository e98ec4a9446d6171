// The interface of a backend for relaxation: the verbs of an iteration, run in parallel on memory
// that the backend owns.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lattice/lattice.h"

namespace lacuna::relaxing {

// How far sites move in an iteration: a long way, and in the last quarter of the iterations the
// whole way.
inline std::uint32_t way_of(std::uint64_t iteration, std::uint64_t iterations) {
    return iteration < iterations - (iterations + 3) / 4 ? LONG_WAY : WHOLE_WAY;
}

// Relaxes the sites of one lattice. A backend may queue the verbs, or combine two of them. Whatever
// the order of its work, its results are exactly as in docs/design.md, section 9:
//   assign      first limits each weight by the distance to the nearest other site. Then each
//               lattice point with importance belongs to the site of least power; ties go to the
//               lowest index. Lattice points without importance have no owner.
//   accumulate  for each site the number of its lattice points, their mass and its moments
//   move        each site moves way / 256 of the way to its centre of mass, and its weight follows
//               its mass. A site without mass stays where it is.
//   rest        replaces the last move, by the whole way. A site without importance under it goes
//               to the nearest of its lattice points or, if it has none, to the nearest lattice
//               point with importance; ties go to the lowest row, then column
// Throws DeviceError, and Cancelled if the watch returns false.
class RelaxBackend {
public:
    virtual ~RelaxBackend() = default;

    virtual std::string device() const = 0;
    virtual void assign() = 0;
    virtual void accumulate() = 0;
    virtual void move(std::uint32_t way) = 0;
    virtual void rest() = 0;

    // These wait until the queue is idle. Results are ordered by index.
    virtual std::vector<Site> sites() = 0;
    virtual std::vector<Share> shares() = 0;  // as last accumulated
    virtual void restore(std::span<const Site> sites) = 0;

    // Called now and then during long verbs, on the calling thread; false cancels the run.
    virtual void watch(std::function<bool()> may_go_on) = 0;

    // For tests: the owner of each lattice point, row by row; NO_OWNER if it has none.
    virtual std::vector<std::uint32_t> owners() = 0;
};

}  // namespace lacuna::relaxing
