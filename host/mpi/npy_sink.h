// Writes all ranks' samples to one .npy, in the order of admission, by MPI-IO.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/new_file.h"
#include "mpi/mpi_ranks.h"
#include "ranks/generate_on_ranks.h"

namespace lacuna::mpi {

// In each round every rank receives the samples of one range of draw numbers, sorts them, and
// writes them behind the samples of lower ranks. They are written to a temporary file in the same
// folder, which put_in_place() renames. Without that, also after a signal, it is removed. Errors of
// writing are thrown as FailedTogether.
class NpySink : public Sink {
public:
    NpySink(std::string path, MpiRanks& ranks);
    ~NpySink() override;
    NpySink(const NpySink&) = delete;
    NpySink& operator=(const NpySink&) = delete;

    void begin(const Plan& plan) override;
    void take(std::span<const Sample> samples, std::span<const std::uint32_t> numbers,
              std::uint32_t draws) override;
    // Writes the header, flushes the file to the disk and closes it.
    void finish();
    // Gives the finished file its name.
    void put_in_place();
    // Closes the file if it is open. Every rank must call it.
    void close();

    // SHA-256 of all points. Call it on rank 0 only, after finish() and before put_in_place().
    std::string sha256() const;

    // The bytes that this rank has sent to other ranks, which write them.
    std::uint64_t bytes_sent() const { return bytes_sent_; }
    double seconds() const { return seconds_; }

private:
    struct Record {
        std::uint32_t number;
        std::uint32_t x;
        std::uint32_t y;
    };
    void open();
    std::vector<Record> redistribute(std::span<const Sample> samples,
                                     std::span<const std::uint32_t> numbers, std::uint32_t draws);
    void write(std::uint64_t first, std::span<const Record> records);
    void write_at(std::uint64_t offset, const void* bytes, std::size_t size) const;

    std::string path_;
    MpiRanks& ranks_;
    std::unique_ptr<files::NewFile> file_;  // rank 0's
    std::string name_;
    MPI_File handle_ = MPI_FILE_NULL;
    MPI_Datatype record_ = MPI_DATATYPE_NULL;
    std::optional<Plan> plan_;
    std::uint64_t written_ = 0;  // samples of all ranks, in earlier rounds
    std::uint64_t bytes_sent_ = 0;
    double seconds_ = 0;
};

}  // namespace lacuna::mpi
