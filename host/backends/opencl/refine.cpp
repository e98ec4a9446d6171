// refine: what all samples leave of the places, in boxes (DESIGN section 4, "exact").
#include "backends/opencl/refine.h"

#include <utility>

namespace lacuna::opencl {
namespace {

// Strips kept in the time that a draw takes.
constexpr std::uint32_t kStripsPerDraw = 4;

// Sums the counts, so that each becomes the place of what is counted; returns how many.
std::uint32_t scan(State& s, std::uint32_t count, std::uint32_t block) {
    const std::uint32_t blocks = items_of(count, block);
    s.queue.launch(s.kernels.scan, blocks, count, block, s.counts, s.sums, s.failure);
    s.queue.launch(s.kernels.scan, 1, blocks, blocks, s.sums, s.total, s.failure);
    s.queue.start_read<std::uint32_t>(s.total, s.host_total);
    s.read_flags();
    return s.host_total.front();
}

void queue_unfold(State& s, bool writes, std::uint32_t block) {
    for (std::size_t i = 0; i < s.slabs.size(); ++i)
        s.queue.launch(s.kernels.unfold, s.slabs[i].lines(), s.geometry, s.slabs[i].first_line,
                       s.slabs[i].end_line, cl_uint{writes}, block, s.spans[i], s.span_counts,
                       s.counts, s.sums, s.boxes.x, s.boxes.begin, s.boxes.end, s.failure);
}

// Makes boxes of the free spans.
void unfold(State& s) {
    const std::uint32_t block = s.queue.block_of(s.plan.lines + 1);
    s.make_room_for_strips(s.plan.lines);
    s.make_room(s.boxes, 0);
    queue_unfold(s, false, block);
    s.place_count = scan(s, s.plan.lines + 1, block);
    s.make_room(s.boxes, s.place_count);
    queue_unfold(s, true, block);
    s.box_width = s.plan.strip_width;
    s.slabs.clear();
    s.spans.clear();
}

// Cuts the boxes in as many strips each, to new boxes.
void cut(State& s, std::uint32_t parts) {
    const std::uint32_t width = s.box_width / parts;
    const std::uint32_t strips = s.place_count * parts;
    const std::uint32_t block = s.queue.block_of(strips + 1);
    s.make_room_for_strips(strips);
    std::uint32_t chunk = s.queue.chunk_of(s.place_count);
    s.queue.launch_in_slices(s.kernels.cut, items_of(s.place_count, chunk), s.place_count,
                             s.geometry, s.place_count, chunk, width, parts, s.boxes.x,
                             s.boxes.begin, s.boxes.end, s.grid_x, s.grid_y, s.counts,
                             s.piece_begin, s.piece_end, s.failure);
    const std::uint32_t pieces = s.place_count == 0 ? 0 : scan(s, strips + 1, block);

    s.make_room(s.new_boxes, pieces);
    s.make_room_for_lengths(pieces);
    chunk = s.queue.chunk_of(strips);
    s.queue.launch_in_slices(s.kernels.keep, items_of(strips, chunk), strips / kStripsPerDraw,
                             s.geometry, s.place_count, chunk, width, parts, block, s.boxes.x,
                             s.boxes.begin, s.boxes.end, s.grid_x, s.grid_y, s.counts, s.sums,
                             s.piece_begin, s.piece_end, s.new_boxes.x, s.new_boxes.begin,
                             s.new_boxes.end, s.free_lengths, s.failure);
    std::swap(s.boxes, s.new_boxes);
    s.place_count = pieces;
    s.box_width = width;
    s.queue.launch(s.kernels.find_place_begins, s.geometry.columns + 1, s.geometry, pieces,
                   s.boxes.x, s.place_begins);
    s.queue.start_read<std::uint32_t>(s.place_begins, s.host_place_begins);
}

}  // namespace

void queue_insert(State& s) {
    const std::uint32_t chunk = s.queue.chunk_of(s.draw_count);
    s.queue.launch_in_slices(s.kernels.insert, items_of(s.draw_count, chunk), s.draw_count,
                             s.geometry, kPasses - 1, s.draw_count, chunk, s.undecided,
                             s.candidates, s.fates, s.grid_x, s.grid_y);
}

void refine(State& s, bool halve) {
    queue_insert(s);
    if (!s.has_boxes()) unfold(s);
    cut(s, halve ? 2 : 1);
}

}  // namespace lacuna::opencl
