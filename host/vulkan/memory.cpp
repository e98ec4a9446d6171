// The vulkan backend's memory, and what moves between it and the host.
#include "vulkan/memory.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "columns.h"
#include "vulkan/transfer.h"

namespace lacuna::vulkan {
namespace {

template <typename T>
void put(const std::vector<T>& values, const Buffer& staging) {
    std::memcpy(staging.as<T>().data(), values.data(), values.size() * sizeof(T));
}

}  // namespace

Memory::Memory(const Plan& the_plan, Engine& the_engine, const Kernel& grow,
               std::uint64_t the_largest_slab)
    : plan(the_plan),
      engine(the_engine),
      grow_kernel(grow),
      largest_slab(the_largest_slab),
      geometry(device::geometry_of(plan, count_columns(plan), 0)) {
    const std::uint64_t columns = geometry.columns;
    span_counts = words_on_device(engine, plan.lines);
    free_lengths = words_on_device(engine, plan.lines);
    column_begins = words_on_device(engine, columns + 1);
    near_begins = words_on_device(engine, columns + 1);
    near_counts = words_on_device(engine, columns);
    undecided = words_on_device(engine, kPasses);
    overflow = words_on_device(engine, 1);
    failure = words_on_device(engine, 1);
    column_begins_up = host_copy_of(engine, column_begins, Engine::Memory::upload);
    near_begins_up = host_copy_of(engine, near_begins, Engine::Memory::upload);
    free_lengths_down = host_copy_of(engine, free_lengths, Engine::Memory::download);
    undecided_down = host_copy_of(engine, undecided, Engine::Memory::download);
    overflow_down = host_copy_of(engine, overflow, Engine::Memory::download);
    failure_down = host_copy_of(engine, failure, Engine::Memory::download);

    // Every line has one free span, the whole of it: a slot of one span each, moved to where it
    // has room to grow.
    engine.fill(span_counts, 1, plan.lines * kWord);
    engine.fill(free_lengths, plan.height, plan.lines * kWord);
    Geometry whole = geometry;
    whole.capacity = 1;
    make_slabs(first_capacity(plan));
    std::vector<Buffer> ones;
    for (const device::Slab& slab : slabs) {
        ones.push_back(on_device(engine, slab.lines() * sizeof(Span)));
        write<Span>(engine, ones.back(), std::vector<Span>(slab.lines(), Span{0, plan.height}));
    }
    engine.barrier();
    move_spans(whole, slabs, ones);
    engine.wait();
}

void Memory::make_slabs(std::uint32_t capacity) {
    geometry.capacity = capacity;
    slabs = device::share_out(plan.lines, capacity, largest_slab);
    spans.clear();
    for (const device::Slab& slab : slabs)
        spans.push_back(on_device(engine, std::uint64_t{slab.lines()} * capacity * sizeof(Span)));
}

void Memory::move_spans(const Geometry& g, std::span<const device::Slab> from_slabs,
                        std::span<const Buffer> from) {
    for (std::size_t i = 0; i < from_slabs.size(); ++i) {
        for (std::size_t j = 0; j < slabs.size(); ++j) {
            const std::uint32_t first = std::max(from_slabs[i].first_line, slabs[j].first_line);
            const std::uint32_t end = std::min(from_slabs[i].end_line, slabs[j].end_line);
            if (first >= end) continue;
            const GrowArguments arguments{0,     g,   from_slabs[i].first_line, slabs[j].first_line,
                                          first, end, geometry.capacity};
            engine.dispatch(grow_kernel, {span_counts, from[i], spans[j]}, arguments, end - first);
        }
    }
}

void Memory::grow() {
    const Geometry old = geometry;
    const std::vector<device::Slab> old_slabs = std::move(slabs);
    const std::vector<Buffer> old_spans = std::move(spans);
    make_slabs(2 * old.capacity);
    engine.barrier();
    move_spans(old, old_slabs, old_spans);
    engine.barrier();
}

void Memory::drop_spans() {
    slabs.clear();
    spans.clear();
}

// What the buffers of a round held is lost when they grow: a round writes before it reads.
void Memory::make_room(std::uint32_t count) {
    if (draw_room_ < count || draw_room_ == 0) {
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
    if (near_room_ < near_begins_.back() || near_room_ == 0) {
        near_room_ = near_begins_.back();
        near = on_device(engine, std::uint64_t{near_room_} * sizeof(Sample));
    }
}

// Expects column_begins_. The barrier that ends the uploads is the caller's.
void Memory::begin_round(std::uint32_t count) {
    device::find_near_begins(plan, geometry.columns, column_begins_, near_begins_);
    draw_count = count;
    make_room(count);
    put(column_begins_, column_begins_up);
    put(near_begins_, near_begins_up);
    engine.copy(column_begins_up, column_begins, column_begins_.size() * kWord);
    engine.copy(near_begins_up, near_begins, near_begins_.size() * kWord);
    engine.fill(undecided, 0, kPasses * kWord);
    engine.fill(overflow, 0, kWord);
    engine.fill(failure, 0, kWord);
}

void Memory::upload(std::span<const Draw> the_draws, std::span<const std::uint32_t> place_begins) {
    find_column_begins(place_begins, the_draws, column_begins_);
    begin_round(static_cast<std::uint32_t>(the_draws.size()));
    if (!the_draws.empty())
        std::memcpy(draws_up.as<Draw>().data(), the_draws.data(), the_draws.size_bytes());
    engine.copy(draws_up, draws, the_draws.size_bytes());
    engine.barrier();
}

void Memory::download() {
    engine.barrier();
    engine.copy(samples, samples_down, std::uint64_t{draw_count} * sizeof(Sample));
    if (!slabs.empty()) engine.copy(free_lengths, free_lengths_down, plan.lines * kWord);
    engine.copy(undecided, undecided_down, kPasses * kWord);
    engine.copy(overflow, overflow_down, kWord);
    engine.copy(failure, failure_down, kWord);
}

void Memory::snapshot_spans(Snapshot& snapshot) {
    const auto counts = read<std::uint32_t>(engine, span_counts, plan.lines);
    for (std::size_t i = 0; i < slabs.size(); ++i) {
        const std::size_t slots = std::size_t{slabs[i].lines()} * geometry.capacity;
        device::unpack(slabs[i], read<Span>(engine, spans[i], slots), counts, snapshot);
    }
}

void Memory::snapshot_round(Snapshot& snapshot) {
    snapshot.capacity = geometry.capacity;
    snapshot.candidates = read<Candidate>(engine, candidates, draw_count);
    snapshot.fates = read<std::uint32_t>(engine, fates, draw_count);
}

void Memory::restore_spans(const Snapshot& snapshot) {
    make_slabs(snapshot.capacity);
    for (std::size_t i = 0; i < slabs.size(); ++i)
        write<Span>(engine, spans[i], device::pack(slabs[i], snapshot));
    std::vector<std::uint32_t> counts;
    std::vector<std::uint32_t> lengths(plan.lines, 0);
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        counts.push_back(static_cast<std::uint32_t>(snapshot.spans[line].size()));
        for (const Span span : snapshot.spans[line]) lengths[line] += span.end - span.begin;
    }
    write<std::uint32_t>(engine, span_counts, counts);
    write<std::uint32_t>(engine, free_lengths, lengths);
    engine.wait();
}

void Memory::begin_restored_round(const Snapshot& snapshot) {
    find_column_begins(plan, geometry.columns, snapshot.candidates, column_begins_);
    begin_round(static_cast<std::uint32_t>(snapshot.candidates.size()));
    write<Candidate>(engine, located, snapshot.candidates);
    engine.barrier();
}

void Memory::restore_fates(const Snapshot& snapshot) {
    write<std::uint32_t>(engine, fates, snapshot.fates);
    write<Sample>(engine, samples, device::samples_by_order(snapshot));
    engine.wait();
}

}  // namespace lacuna::vulkan
