// Sends samples to the ranks that write them, which write them at their offsets in the file.
#include "mpi/npy_sink.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <system_error>
#include <utility>

#include "files/descriptor.h"
#include "files/npy.h"
#include "files/point_files.h"
#include "mpi/unfinished_file.h"
#include "ranks/together.h"

namespace lacuna::mpi {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little && sizeof(Point) == 16);

// Points that are converted to the user's units and written at a time: 4 MB.
constexpr std::size_t kPointsAtOnce = std::size_t{1} << 18;

// A header has this length whatever the number of points.
std::uint64_t header_bytes() {
    return files::npy_header(0, 2).size();
}

// MPI_File_open hangs if it fails on some ranks only, so each rank first checks that it can write
// into rank 0's file. It is known by its random name: over NFS its inode may differ.
void check_is_shared(const std::string& name, const std::string& path, std::uint32_t rank) {
    const files::Descriptor descriptor(::open(name.c_str(), O_WRONLY | O_CLOEXEC));
    if (descriptor.number() >= 0 && ::write(descriptor.number(), "", 1) == 1) return;
    const std::string reason = std::generic_category().message(errno);
    std::error_code ignored;
    throw files::FileError(path + ": rank " + std::to_string(rank) + ", in the folder " +
                           fs::current_path(ignored).string() + ", cannot write into " + name +
                           ", which rank 0 made (" + reason +
                           "): must be in a folder into which all ranks can write");
}

}  // namespace

NpySink::NpySink(std::string path, MpiRanks& ranks) : path_(std::move(path)), ranks_(ranks) {
    MPI_Type_contiguous(3, MPI_UINT32_T, &record_);
    MPI_Type_commit(&record_);
    remove_on_signal("", ranks_.rank() == 0);
}

NpySink::~NpySink() {
    MPI_Type_free(&record_);
    // No message on a signal from now on: mpirun ends ranks that are slower to exit by a signal,
    // and the message about the run has been printed already.
    remove_on_signal("", false);
}

void NpySink::close() {
    if (handle_ != MPI_FILE_NULL) MPI_File_close(&handle_);
}

void NpySink::open() {
    together(ranks_, [&] {
        if (ranks_.rank() != 0) return;
        // A signal waits until the handler knows the file's name.
        const SignalsWait wait;
        file_ = std::make_unique<files::NewFile>(path_);
        name_ = file_->name();
        remove_on_signal(name_, true);
    });
    auto length = static_cast<int>(name_.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, ranks_.communicator());
    name_.resize(static_cast<std::size_t>(length));
    MPI_Bcast(name_.data(), length, MPI_CHAR, 0, ranks_.communicator());
    remove_on_signal(name_, ranks_.rank() == 0);
    together(ranks_, [&] { check_is_shared(name_, path_, ranks_.rank()); });
    const int error = MPI_File_open(ranks_.communicator(), name_.c_str(), MPI_MODE_WRONLY,
                                    MPI_INFO_NULL, &handle_);
    together(ranks_, [&] {
        if (error == MPI_SUCCESS) return;
        throw files::FileError(path_ + ": rank " + std::to_string(ranks_.rank()) +
                               " cannot open the file that rank 0 made beside it");
    });
}

void NpySink::begin(const Plan& plan) {
    if (handle_ == MPI_FILE_NULL) open();
    plan_ = plan;
    written_ = 0;
    // Empties the file: an earlier attempt at the count may have written a longer set.
    MPI_File_set_size(handle_, 0);
}

// Gives each rank the records of one range of draw numbers, and returns this rank's, sorted.
std::vector<NpySink::Record> NpySink::redistribute(std::span<const Sample> samples,
                                                   std::span<const std::uint32_t> numbers,
                                                   std::uint32_t draws) {
    const std::uint32_t ranks = ranks_.count();
    const auto first_of = [&](std::uint64_t rank) {
        return static_cast<std::uint32_t>(rank * draws / ranks);
    };
    std::vector<Record> sent(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        sent[i] = {numbers[i], samples[i].x, samples[i].y};
    std::vector<int> to_send(ranks), send_begins(ranks), to_get(ranks), get_begins(ranks);
    for (std::uint32_t rank = 0; rank < ranks; ++rank) {
        const auto begin = std::lower_bound(numbers.begin(), numbers.end(), first_of(rank));
        const auto end = std::lower_bound(begin, numbers.end(), first_of(rank + 1));
        send_begins[rank] = static_cast<int>(begin - numbers.begin());
        to_send[rank] = static_cast<int>(end - begin);
        if (rank != ranks_.rank())
            bytes_sent_ += static_cast<std::uint64_t>(to_send[rank]) * sizeof(Record);
    }
    MPI_Alltoall(to_send.data(), 1, MPI_INT, to_get.data(), 1, MPI_INT, ranks_.communicator());
    std::exclusive_scan(to_get.begin(), to_get.end(), get_begins.begin(), 0);
    std::vector<Record> got(static_cast<std::size_t>(get_begins.back() + to_get.back()));
    MPI_Alltoallv(sent.data(), to_send.data(), send_begins.data(), record_, got.data(),
                  to_get.data(), get_begins.data(), record_, ranks_.communicator());
    sent = {};
    // Sorts: every draw number has its own entry in this rank's range.
    const std::uint32_t first = first_of(ranks_.rank());
    constexpr Record kNone{~std::uint32_t{0}, 0, 0};
    std::vector<Record> by_number(first_of(ranks_.rank() + 1) - first, kNone);
    for (const Record& record : got) by_number[record.number - first] = record;
    std::erase_if(by_number, [](const Record& record) { return record.number == kNone.number; });
    return by_number;
}

void NpySink::take(std::span<const Sample> samples, std::span<const std::uint32_t> numbers,
                   std::uint32_t draws) {
    const double begin = MPI_Wtime();
    const std::vector<Record> records = redistribute(samples, numbers, draws);
    const std::uint64_t first = written_ + ranks_.sum_below(records.size());
    std::array<std::uint64_t, 1> all{records.size()};
    ranks_.sum(all);
    const std::uint64_t wanted =
        std::min<std::uint64_t>(records.size(), plan_->limit - std::min(plan_->limit, first));
    together(ranks_, [&] { write(first, std::span(records).first(wanted)); });
    written_ += all.front();
    seconds_ += MPI_Wtime() - begin;
}

void NpySink::write(std::uint64_t first, std::span<const Record> records) {
    std::vector<Point> points;
    while (!records.empty()) {
        const auto now = records.first(std::min(records.size(), kPointsAtOnce));
        points.clear();
        for (const Record& record : now) points.push_back(plan_->to_user({record.x, record.y}));
        write_at(header_bytes() + first * sizeof(Point), points.data(),
                 points.size() * sizeof(Point));
        first += now.size();
        records = records.subspan(now.size());
    }
}

void NpySink::write_at(std::uint64_t offset, const void* bytes, std::size_t size) const {
    // If only some of the bytes fit on the disk or into `ulimit -f`, MPI writes these without an
    // error. The next attempt, for the other bytes, then fails with the reason.
    for (std::size_t done = 0; done < size;) {
        MPI_Status status{};
        const std::uint64_t next = offset + done;
        errno = 0;
        const int error = MPI_File_write_at(handle_, static_cast<MPI_Offset>(next),
                                            static_cast<const char*>(bytes) + done,
                                            static_cast<int>(size - done), MPI_BYTE, &status);
        const int reason = errno;
        int count = 0;
        if (error == MPI_SUCCESS) MPI_Get_count(&status, MPI_BYTE, &count);
        if (count <= 0) files::fail_to_write(path_, reason != 0 ? reason : ENOSPC);
        done += static_cast<std::size_t>(count);
    }
}

void NpySink::finish() {
    const std::uint64_t count = std::min(written_, plan_->limit);
    together(ranks_, [&] {
        if (ranks_.rank() != 0) return;
        const std::string header = files::npy_header(count, 2);
        write_at(0, header.data(), header.size());
    });
    const int error = MPI_File_sync(handle_);
    together(ranks_, [&] {
        if (error != MPI_SUCCESS) files::fail_to_write(path_, EIO);
    });
    close();
}

void NpySink::put_in_place() {
    together(ranks_, [&] {
        if (ranks_.rank() == 0) file_->put_in_place();
    });
    remove_on_signal("", ranks_.rank() == 0);
}

std::string NpySink::sha256() const {
    std::ifstream file(name_, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(header_bytes()));
    files::Sha256OfPoints digest;
    std::vector<Point> points(kPointsAtOnce);
    while (file) {
        file.read(reinterpret_cast<char*>(points.data()),
                  static_cast<std::streamsize>(points.size() * sizeof(Point)));
        digest.add(
            std::span(points).first(static_cast<std::size_t>(file.gcount()) / sizeof(Point)));
    }
    return digest.hex();
}

}  // namespace lacuna::mpi
