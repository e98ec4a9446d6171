// The vulkan backend's memory in lines and exact, and what moves between it and the host.
#include "backends/vulkan/memory.h"

#include <algorithm>
#include <utility>

#include "backends/columns.h"
#include "backends/vulkan/transfer.h"

namespace lacuna::vulkan {

Memory::Memory(const Plan& the_plan, Engine& the_engine, const Kernel& grow,
               std::uint64_t the_largest_slab)
    : RoundMemory(the_plan, the_engine), grow_kernel(grow), largest_slab(the_largest_slab) {
    const std::uint64_t columns = geometry.columns;
    span_counts = words_on_device(engine, plan.lines);
    free_lengths = words_on_device(engine, plan.lines);
    near_begins = words_on_device(engine, columns + 1);
    near_counts = words_on_device(engine, columns);
    overflow = words_on_device(engine, 1);
    near_begins_up = host_copy_of(engine, near_begins, Engine::Memory::upload);
    free_lengths_down = host_copy_of(engine, free_lengths, Engine::Memory::download);
    overflow_down = host_copy_of(engine, overflow, Engine::Memory::download);

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

// Expects column_begins_. What `near` held is lost when it grows: a round writes before it reads.
void Memory::begin_near() {
    device::find_near_begins(plan, geometry.columns, column_begins_, near_begins_);
    if (near_room_ < near_begins_.back() || near_room_ == 0) {
        near_room_ = near_begins_.back();
        near = on_device(engine, std::uint64_t{near_room_} * sizeof(Sample));
    }
    put(near_begins_, near_begins_up);
    engine.copy(near_begins_up, near_begins, near_begins_.size() * kWord);
    engine.fill(overflow, 0, kWord);
    engine.barrier();
}

void Memory::upload(std::span<const Draw> the_draws, std::span<const std::uint32_t> place_begins) {
    RoundMemory::upload(the_draws, place_begins);
    begin_near();
}

void Memory::download() {
    RoundMemory::download();
    if (!slabs.empty()) engine.copy(free_lengths, free_lengths_down, plan.lines * kWord);
    engine.copy(overflow, overflow_down, kWord);
}

void Memory::snapshot_spans(Snapshot& snapshot) {
    const auto counts = read<std::uint32_t>(engine, span_counts, plan.lines);
    for (std::size_t i = 0; i < slabs.size(); ++i) {
        const std::size_t slots = std::size_t{slabs[i].lines()} * geometry.capacity;
        device::unpack(slabs[i], read<Span>(engine, spans[i], slots), counts, snapshot);
    }
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
    RoundMemory::begin_restored_round(snapshot);
    begin_near();
}

}  // namespace lacuna::vulkan
