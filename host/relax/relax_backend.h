// What a backend of relaxation is: the verbs of an iteration, done in parallel on memory of its
// own.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "relax/lattice.h"

namespace lacuna::relaxing {

// Serves one lattice and its sites. A backend may queue the verbs, or do two at once. Whatever the
// order of its work, the outcome is that of docs/design.md, section 9, whole number
// for whole number:
//   assign      each lattice point of importance belongs to the sample of least power; ties go to
//   the
//           lowest index. Lattice points without importance belong to nobody.
//   accumulate  each sample's share: how many lattice points it owns, their mass and its moments
//   move        each sample moves to its centre of mass, and its weight follows its mass; then the
//   least
//           of all weights is taken off. A sample without mass stays where it is.
//   rest    in place of the last move: the same, and then a sample without importance under it
//   goes
//           to the lattice point nearest to it among those that it owned or, where it owned none,
//           among all of importance; ties go to the lowest row, then column
// Throws DeviceError, and Cancelled when a watch says so.
class RelaxBackend {
public:
    virtual ~RelaxBackend() = default;

    virtual std::string device() const = 0;
    virtual void assign() = 0;
    virtual void accumulate() = 0;
    virtual void move() = 0;
    virtual void rest() = 0;

    // Wait for what is queued. By index.
    virtual std::vector<Site> sites() = 0;
    virtual std::vector<Share> shares() = 0;  // as last accumulated
    virtual void restore(std::span<const Site> sites) = 0;

    // Asked now and then during long verbs, from the calling thread; false cancels the run.
    virtual void watch(std::function<bool()> may_go_on) = 0;

    // For tests: who owns each lattice point, row by row, NO_OWNER where nobody does.
    virtual std::vector<std::uint32_t> owners() = 0;
};

}  // namespace lacuna::relaxing
