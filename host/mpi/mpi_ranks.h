// The ranks of an MPI communicator.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>

#include "ranks/ranks.h"

namespace lacuna::mpi {

class MpiRanks : public Ranks {
public:
    // MPI must be initialised for as long as this lives.
    explicit MpiRanks(MPI_Comm communicator);

    std::uint32_t rank() const override { return rank_; }
    std::uint32_t count() const override { return count_; }
    MPI_Comm communicator() const { return communicator_; }

    Sides exchange(const Sides& sent) override;
    void sum(std::span<std::uint64_t> values) override;
    std::uint64_t sum_below(std::uint64_t value) override;

    // What this rank has sent to its neighbours, how often ranks added up, and how long all that
    // took, with the time to wait for the others.
    struct Cost {
        std::uint64_t bytes = 0;
        std::uint64_t sums = 0;
        double seconds = 0;
    };
    const Cost& cost() const { return cost_; }

private:
    MPI_Comm communicator_;
    std::uint32_t rank_;
    std::uint32_t count_;
    Cost cost_;
};

}  // namespace lacuna::mpi
