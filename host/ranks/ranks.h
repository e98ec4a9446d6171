// The interface to other processes that make the same set: MPI in mpi/, threads in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lacuna {

// Bytes for the two neighbours, or from them. The ranks form a ring.
struct Sides {
    std::vector<std::byte> low;
    std::vector<std::byte> high;
};

// Every rank makes the same calls in the same order; each call waits for the other ranks.
class Ranks {
public:
    virtual ~Ranks() = default;

    virtual std::uint32_t rank() const = 0;
    virtual std::uint32_t count() const = 0;

    // Sends to both neighbours, and returns what they sent. If there are two ranks, each is the
    // other's neighbour on both sides.
    virtual Sides exchange(const Sides& sent) = 0;
    // Replaces the values by their sums over all ranks.
    virtual void sum(std::span<std::uint64_t> values) = 0;
    // Returns the sum over all ranks below this one.
    virtual std::uint64_t sum_below(std::uint64_t value) = 0;
};

}  // namespace lacuna
