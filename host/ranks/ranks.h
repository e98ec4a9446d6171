// What the library knows of other processes that make the same set: MPI's in mpi/, threads in
// tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lacuna {

// Bytes for the neighbour on either side, or from it: the ranks stand in a ring.
struct Sides {
    std::vector<std::byte> low;
    std::vector<std::byte> high;
};

// Every rank makes the same calls in the same order; each waits for what the others have to give.
class Ranks {
public:
    virtual ~Ranks() = default;

    virtual std::uint32_t rank() const = 0;
    virtual std::uint32_t count() const = 0;

    // Sends to both neighbours, and returns what they sent here. Of two ranks each is the other's
    // neighbour on both sides.
    virtual Sides exchange(const Sides& sent) = 0;
    // The sums over all ranks, in place.
    virtual void sum(std::span<std::uint64_t> values) = 0;
    // The sum over the ranks below this one.
    virtual std::uint64_t sum_below(std::uint64_t value) = 0;
};

}  // namespace lacuna
