// The ranks of an MPI communicator.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>

#include "ranks/ranks.h"

namespace lacuna::mpi {

class MpiRanks : public Ranks {
public:
    // MPI must be initialised before, and finalised only after the destructor.
    explicit MpiRanks(MPI_Comm communicator);

    std::uint32_t rank() const override { return rank_; }
    std::uint32_t count() const override { return count_; }
    MPI_Comm communicator() const { return communicator_; }

    Sides exchange(const Sides& sent) override;
    void sum(std::span<std::uint64_t> values) override;
    std::uint64_t sum_below(std::uint64_t value) override;

    struct Cost {
        std::uint64_t bytes = 0;  // sent to neighbours
        std::uint64_t sums = 0;   // calls of sum and sum_below
        double seconds = 0;       // in exchanges and sums, with the wait for other ranks
    };
    const Cost& cost() const { return cost_; }

private:
    MPI_Comm communicator_;
    std::uint32_t rank_;
    std::uint32_t count_;
    Cost cost_;
};

}  // namespace lacuna::mpi
