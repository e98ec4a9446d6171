// Messages between neighbours, and sums over ranks, by MPI.
#include "mpi/mpi_ranks.h"

#include <array>
#include <vector>

namespace lacuna::mpi {
namespace {

// Tags: to which neighbour a message goes.
constexpr int kToLow = 1;
constexpr int kToHigh = 2;

std::uint32_t rank_in(MPI_Comm communicator) {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    return static_cast<std::uint32_t>(rank);
}

std::uint32_t size_of(MPI_Comm communicator) {
    int size = 0;
    MPI_Comm_size(communicator, &size);
    return static_cast<std::uint32_t>(size);
}

// Adds its lifetime to `seconds`.
class Clock {
public:
    explicit Clock(double& seconds) : seconds_(seconds), begin_(MPI_Wtime()) {}
    ~Clock() { seconds_ += MPI_Wtime() - begin_; }
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

private:
    double& seconds_;
    double begin_;
};

// Receives a message of any length.
std::vector<std::byte> receive(int from, int tag, MPI_Comm communicator) {
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status{};
    MPI_Mprobe(from, tag, communicator, &message, &status);
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    std::vector<std::byte> bytes(static_cast<std::size_t>(count));
    MPI_Mrecv(bytes.data(), count, MPI_BYTE, &message, MPI_STATUS_IGNORE);
    return bytes;
}

}  // namespace

MpiRanks::MpiRanks(MPI_Comm communicator)
    : communicator_(communicator), rank_(rank_in(communicator)), count_(size_of(communicator)) {}

Sides MpiRanks::exchange(const Sides& sent) {
    const Clock clock(cost_.seconds);
    const auto low = static_cast<int>((rank_ + count_ - 1) % count_);
    const auto high = static_cast<int>((rank_ + 1) % count_);
    std::array<MPI_Request, 2> requests{};
    MPI_Isend(sent.low.data(), static_cast<int>(sent.low.size()), MPI_BYTE, low, kToLow,
              communicator_, &requests[0]);
    MPI_Isend(sent.high.data(), static_cast<int>(sent.high.size()), MPI_BYTE, high, kToHigh,
              communicator_, &requests[1]);
    Sides got;
    got.low = receive(low, kToHigh, communicator_);
    got.high = receive(high, kToLow, communicator_);
    MPI_Waitall(2, requests.data(), MPI_STATUSES_IGNORE);
    cost_.bytes += sent.low.size() + sent.high.size();
    return got;
}

void MpiRanks::sum(std::span<std::uint64_t> values) {
    const Clock clock(cost_.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_UINT64_T,
                  MPI_SUM, communicator_);
    ++cost_.sums;
}

std::uint64_t MpiRanks::sum_below(std::uint64_t value) {
    const Clock clock(cost_.seconds);
    std::uint64_t below = 0;
    MPI_Exscan(&value, &below, 1, MPI_UINT64_T, MPI_SUM, communicator_);
    ++cost_.sums;
    return rank_ == 0 ? 0 : below;  // MPI leaves rank 0's result undefined
}

}  // namespace lacuna::mpi
