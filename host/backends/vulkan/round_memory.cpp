// What every mode keeps on the device of a round, and what moves between it and the host.
#include "backends/vulkan/round_memory.h"

#include <array>
#include <cstring>
#include <string>

#include "backends/columns.h"
#include "backends/device/layout.h"
#include "backends/vulkan/transfer.h"
#include "portable/failure.h"

namespace lacuna::vulkan {
namespace {

constexpr std::uint32_t kSortWork = 4;  // a draw; see Engine::dispatch

struct Failure {
    std::uint32_t bit;
    const char* verb;
};
constexpr std::array kFailures{
    Failure{FAILED_LOCATE, "locate"},     Failure{FAILED_SORT_COLUMNS, "locate"},
    Failure{FAILED_ADMIT, "admit"},       Failure{FAILED_GATHER, "subtract"},
    Failure{FAILED_SUBTRACT, "subtract"}, Failure{FAILED_REFINE, "refine"},
};

}  // namespace

RoundMemory::RoundMemory(const Plan& the_plan, Engine& the_engine)
    : plan(the_plan),
      engine(the_engine),
      geometry(device::geometry_of(plan, count_columns(plan), 0)) {
    column_begins = words_on_device(engine, geometry.columns + std::uint64_t{1});
    undecided = words_on_device(engine, kPasses);
    failure = words_on_device(engine, 1);
    column_begins_up = host_copy_of(engine, column_begins, Engine::Memory::upload);
    undecided_down = host_copy_of(engine, undecided, Engine::Memory::download);
    failure_down = host_copy_of(engine, failure, Engine::Memory::download);
}

// What the buffers of a round held is lost when they grow: a round writes before it reads.
void RoundMemory::make_room(std::uint32_t count) {
    if (count <= draw_room_ && draw_room_ != 0) return;
    draw_room_ = count;
    draws = on_device(engine, std::uint64_t{count} * sizeof(Draw));
    located = on_device(engine, std::uint64_t{count} * sizeof(Candidate));
    buckets = words_on_device(engine, count);
    candidates = on_device(engine, std::uint64_t{count} * sizeof(Candidate));
    fates = words_on_device(engine, count);
    samples = on_device(engine, std::uint64_t{count} * sizeof(Sample));
    draws_up = host_copy_of(engine, draws, Engine::Memory::upload);
    samples_down = host_copy_of(engine, samples, Engine::Memory::download);
}

// Expects column_begins_.
void RoundMemory::begin_round(std::uint32_t count) {
    draw_count = count;
    make_room(count);
    put(column_begins_, column_begins_up);
    engine.copy(column_begins_up, column_begins, column_begins_.size() * kWord);
    engine.fill(undecided, 0, kPasses * kWord);
    engine.fill(failure, 0, kWord);
}

void RoundMemory::upload(std::span<const Draw> the_draws,
                         std::span<const std::uint32_t> place_begins) {
    find_column_begins(place_begins, the_draws, column_begins_);
    begin_round(static_cast<std::uint32_t>(the_draws.size()));
    if (!the_draws.empty())
        std::memcpy(draws_up.as<Draw>().data(), the_draws.data(), the_draws.size_bytes());
    engine.copy(draws_up, draws, the_draws.size_bytes());
}

void RoundMemory::download() {
    engine.barrier();
    engine.copy(samples, samples_down, std::uint64_t{draw_count} * sizeof(Sample));
    engine.copy(undecided, undecided_down, kPasses * kWord);
    engine.copy(failure, failure_down, kWord);
}

void RoundMemory::sort(const Kernel& sort_columns) {
    engine.dispatch(sort_columns, {column_begins, located, buckets, candidates, fates, failure},
                    SortColumnsArguments{0, geometry}, geometry.columns,
                    kSortWork * draws_per_column());
    engine.barrier();
}

void RoundMemory::begin_more_passes() {
    engine.fill(undecided, 1, kWord);
    engine.fill(undecided, 0, kWord * (kPasses - 1), kWord);
    engine.barrier();
}

void RoundMemory::throw_if_failed() const {
    const std::uint32_t failed = failure_down.as<std::uint32_t>().front();
    const std::string name = "device " + engine.device().name + ": ";
    if ((failed & FAILED_CHORDS) != 0)
        throw DeviceError(name + "refine: more chords near a box than there is room for");
    for (const Failure& each : kFailures)
        if ((failed & each.bit) != 0)
            throw DeviceError(name + each.verb +
                              ": a loop was ended early by the driver: use fewer points, or "
                              "another backend");
}

// --------------------------------------------------------------------------------- for tests only

void RoundMemory::snapshot_round(Snapshot& snapshot) {
    snapshot.capacity = geometry.capacity;
    snapshot.candidates = read<Candidate>(engine, candidates, draw_count);
    snapshot.fates = read<std::uint32_t>(engine, fates, draw_count);
}

void RoundMemory::begin_restored_round(const Snapshot& snapshot) {
    find_column_begins(plan, geometry.columns, snapshot.candidates, column_begins_);
    begin_round(static_cast<std::uint32_t>(snapshot.candidates.size()));
    write<Candidate>(engine, located, snapshot.candidates);
}

void RoundMemory::restore_fates(const Snapshot& snapshot) {
    write<std::uint32_t>(engine, fates, snapshot.fates);
    write<Sample>(engine, samples, device::samples_by_order(snapshot));
    engine.wait();
}

}  // namespace lacuna::vulkan
