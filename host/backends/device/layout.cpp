// The layout of a plan's memory on a device.
#include "backends/device/layout.h"

#include <algorithm>
#include <limits>

#include "backends/columns.h"
#include "base/number_text.h"
#include "plan/first_boxes.h"
#include "plan/first_free.h"
#include "plan/make_plan.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"
#include "portable/bits.h"
#include "portable/status.h"
#include "rounds/round_policy.h"
#include "space/first_bins.h"

namespace lacuna::device {

std::vector<Slab> share_out(std::uint32_t lines, std::uint32_t capacity,
                            std::uint64_t largest_bytes) {
    const std::uint64_t fit = largest_bytes / (std::uint64_t{capacity} * sizeof(Span));
    const auto step = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(fit, 1, lines));
    std::vector<Slab> slabs;
    for (std::uint32_t line = 0; line < lines; line += step)
        slabs.push_back({line, line + std::min(step, lines - line)});
    return slabs;
}

namespace {

std::uint32_t rule_of(const Plan& plan) {
    if (plan.has_radius_field() && plan.field().radius_field->has_ellipses())
        return RULE_OF_ELLIPSES;
    return plan.is_exact() ? RULE_OF_DISKS : RULE_OF_LINES;
}

}  // namespace

GridShape grid_of(const Plan& plan) {
    if (plan.is_cells() || plan.has_radius_field()) return {};
    if (plan.is_exact()) return plan.grid();
    return lacuna::grid_of(plan.width, plan.height,
                           std::max(plan.radius - plan.strip_width / 2, 2u));
}

Tiles tiles_of(const Plan& plan, std::uint32_t rows) {
    const GridShape grid = grid_of(plan);
    std::uint64_t height = rows;
    while (height * kMostTiles < grid.rows) height *= 2;
    if (height >= grid.rows) return {1, plan.height};
    const auto of_tile = static_cast<std::uint32_t>(height);
    return {(grid.rows - 1) / of_tile + 1, of_tile * grid.side};
}

std::uint32_t first_tile_capacity(const Plan& plan, Tiles tiles) {
    const auto spans =
        static_cast<std::uint64_t>(most_spans(static_cast<double>(tiles.height) / plan.radius));
    // Each sample adds at most one span to a tile.
    return static_cast<std::uint32_t>(std::min(spans, std::min(spans, plan.limit) + 8));
}

portable::Geometry geometry_of(const Plan& plan, std::uint32_t columns, std::uint32_t capacity) {
    const GridShape grid = grid_of(plan);
    return {.radius_squared = plan.radius_squared,
            .radius = plan.radius,
            .width = plan.width,
            .height = plan.height,
            .period_x = plan.period_x,
            .period_y = plan.period_y,
            .lines = plan.lines,
            .strip_width = plan.strip_width,
            .columns = columns,
            .capacity = capacity,
            .rule = rule_of(plan),
            .chord_margin = plan.chord_margin(),
            .grid_side = grid.side,
            .grid_columns = grid.columns,
            .grid_rows = grid.rows,
            .copy_bits = plan.has_radius_field() ? plan.field().copies.bits() : BITS_OF_ONE_COPY};
}

Range draws_of(const Slab& slab, std::span<const Draw> draws) {
    const auto index_of_line = [&](std::uint32_t line) {
        const auto first = std::partition_point(draws.begin(), draws.end(),
                                                [&](const Draw& draw) { return draw.bin < line; });
        return static_cast<std::uint32_t>(first - draws.begin());
    };
    return {index_of_line(slab.first_line), index_of_line(slab.end_line)};
}

std::vector<std::uint32_t> outcomes_of(const Snapshot& snapshot) {
    const std::uint32_t words =
        portable::words_of_column(static_cast<std::uint32_t>(snapshot.candidates.size()));
    std::vector<std::uint32_t> outcomes(2 * std::size_t{words}, 0);
    for (std::size_t i = 0; i < snapshot.candidates.size(); ++i) {
        const std::uint32_t order = snapshot.candidates[i].order;
        const std::uint32_t bit = std::uint32_t{1} << order % 32;
        if (snapshot.statuses[i] == STATUS_ADMITTED) outcomes[order / 32] |= bit;
        if (snapshot.statuses[i] == STATUS_COVERED) outcomes[words + order / 32] |= bit;
    }
    return outcomes;
}

Packed pack(const Slab& slab, Tiles tiles, const Snapshot& snapshot) {
    const std::size_t count = std::size_t{slab.lines()} * tiles.count;
    Packed packed{std::vector<Span>(count * snapshot.capacity),
                  std::vector<std::uint32_t>(count, 0), std::vector<std::uint32_t>(count, 0)};
    for (std::uint32_t i = 0; i < slab.lines(); ++i) {
        for (Span rest : snapshot.spans[slab.first_line + i]) {
            while (rest.begin < rest.end) {
                const std::uint32_t of_line = std::min(rest.begin / tiles.height, tiles.count - 1);
                const std::uint32_t end = of_line + 1 < tiles.count
                                              ? std::min(rest.end, (of_line + 1) * tiles.height)
                                              : rest.end;
                const std::size_t tile = std::size_t{i} * tiles.count + of_line;
                packed.slots[tile * snapshot.capacity + packed.counts[tile]++] = {rest.begin, end};
                packed.lengths[tile] += end - rest.begin;
                rest.begin = end;
            }
        }
    }
    return packed;
}

void unpack(const Slab& slab, Tiles tiles, std::span<const Span> slots,
            std::span<const std::uint32_t> span_counts, Snapshot& snapshot) {
    for (std::uint32_t i = 0; i < slab.lines(); ++i) {
        std::vector<Span>& line = snapshot.spans.emplace_back();
        for (std::uint32_t k = 0; k < tiles.count; ++k) {
            const std::size_t tile = std::size_t{i} * tiles.count + k;
            const std::uint32_t count =
                span_counts[std::size_t{slab.first_line} * tiles.count + tile];
            for (const Span span : slots.subspan(tile * snapshot.capacity, count)) {
                if (!line.empty() && line.back().end == span.begin &&
                    span.begin == k * tiles.height)
                    line.back().end = span.end;
                else
                    line.push_back(span);
            }
        }
    }
}

namespace {

std::string gigabytes(std::uint64_t bytes) {
    return rounded(static_cast<double>(bytes) / 1e9, 3) + " GB";
}

// Bytes of a draw: itself and its candidate; status, next candidate in its cell; sample.
constexpr std::uint64_t kBytesPerDraw = 32 + 8 + 8;
constexpr std::uint64_t kLargestPerDraw = 16;  // of the largest buffer

// Bytes of a cell: its sample, its first candidate, and some bits. In exact, bytes of a box: itself
// before and after a round, the pieces of its two strips, its length and its count.
constexpr std::uint64_t kBytesPerCell = 8 + 4 + 1;
constexpr std::uint64_t kBytesPerBox = 2 * 16 + 2 * 8 + 2 * 4;
// Most boxes for each sample of the maximal set: 0.45 to 0.5 have been seen.
constexpr double kBoxesPerSample = 0.75;

Needs needs_of_lines(const Plan& plan, std::uint64_t round) {
    const Tiles of_line = tiles_of(plan, kRowsOfTile);
    const std::uint64_t tiles = std::uint64_t{plan.lines} * of_line.count;
    const std::uint64_t line_bytes =
        std::uint64_t{first_tile_capacity(plan, of_line)} * of_line.count * sizeof(Span);
    const GridShape grid = grid_of(plan);
    const std::uint64_t cells = std::uint64_t{grid.columns} * grid.rows;
    const auto boxes = static_cast<std::uint64_t>(
        plan.is_exact() ? kBoxesPerSample * static_cast<double>(plan.expected_samples) : 0);
    const std::uint64_t near = std::uint64_t{count_columns(plan)} * kSamplesNearSpan * line_bytes;
    // Of a tile: the number of its spans, their length, and the length below it.
    return {plan.lines * (line_bytes + 4) + tiles * 12 + near + round * kBytesPerDraw +
                cells * kBytesPerCell + boxes * kBytesPerBox,
            std::max({line_bytes, tiles * std::uint64_t{4}, round * kLargestPerDraw, cells * 4,
                      boxes * 16})};
}

// In cells, of a draw: draws, located, candidates; buckets, statuses, radii, todo, left; samples.
constexpr std::uint64_t kCellsBytesPerDraw = 48 + 20 + 8;
constexpr std::uint64_t kCellsLargestPerDraw = 16;

Needs needs_of_cells(const Plan& plan, std::uint64_t round) {
    constexpr std::uint64_t kWord = 4;
    const std::uint64_t bits = std::uint64_t{plan.lines} * words_per_line(plan) * kWord;
    // Radii, reaches and widest rows; column_of, free_lengths and widest; row_of and row_begins.
    const std::uint64_t pixels = plan.cells().radii->radii.size() * kWord;
    const std::uint64_t lines = plan.lines * kWord;
    const std::uint64_t rows =
        std::uint64_t{std::max(plan.height, plan.cells().radii->rows + 1)} * kWord;
    return {bits + 3 * (pixels + lines) + 2 * rows + round * kCellsBytesPerDraw,
            std::max({bits, pixels, lines, rows, round * kCellsLargestPerDraw})};
}

// With a radius field, bytes of a draw: itself, located, candidate; bucket, status, radius, count;
// its sample; the blocks that it reaches. And of a box: itself and its origin, before and after a
// round; the pieces of its four strips, the borders between them and their radii; its count.
constexpr std::uint64_t kFieldBytesPerDraw = 48 + 16 + 8 + 10 * 8;
constexpr std::uint64_t kFieldBytesPerBox = 2 * (16 + 8) + 4 * 8 + 2 * 16 + 4;
constexpr std::uint64_t kBytesPerEntry = 16;
constexpr double kFieldBoxesPerSample = 2.5;
constexpr std::uint64_t kEntriesPerSample = 3;

Needs needs_of_field(const Plan& plan, std::uint64_t round) {
    const RadiusField& radius_field = *plan.field().radius_field;
    // A pyramid has a third more values than pixels.
    const std::uint64_t radii =
        std::uint64_t{radius_field.columns().pixels()} * radius_field.rows().pixels() * 8 * 4 / 3;
    const std::uint64_t mask =
        radius_field.mask() == nullptr ? 0 : std::uint64_t{radius_field.mask()->nodes().size()} * 8;
    const std::uint64_t ellipses = radius_field.ellipses().size() * sizeof(portable::Ellipse);
    const std::uint64_t entries = room_for_entries(plan) * kBytesPerEntry;
    const std::uint64_t boxes = room_for_boxes(plan);
    return {radii + mask + ellipses + entries + boxes * kFieldBytesPerBox +
                plan.field().first_boxes->nodes.size() * 52 + round * kFieldBytesPerDraw,
            std::max({radii, mask, ellipses, entries, boxes * 32, round * 10 * 8})};
}

// In space, bytes of a draw: itself, candidate; height, status, next candidate, third number; its
// sample. Of a bin: itself and its block, before and after a round; its pieces, their count and
// what the host has of it. Of a block: its lists. Of a triangle: three corners.
constexpr std::uint64_t kSpaceBytesPerDraw = 32 + 16 + 12;
constexpr std::uint64_t kSpaceBytesPerBin = 2 * (16 + 4) + 2 * 4 + 8;
constexpr std::uint64_t kBytesPerTriangle = 48;
// `bins`: the largest number of bins for each sample that was measured. `entries`: the lists have
// room for this many entries for each sample that is expected, which is enough for the samples
// before a round and its draws.
struct MostInSpace {
    double bins;
    std::uint64_t entries;
};
constexpr MostInSpace kMostOnSurface{6, 4};
constexpr MostInSpace kMostInVolume{15, 8};

MostInSpace most_in_space(const Plan& plan) {
    return plan.space().first_bins->is_volume() ? kMostInVolume : kMostOnSurface;
}

Needs needs_of_space(const Plan& plan, std::uint64_t round) {
    const space::FirstBins& first = *plan.space().first_bins;
    const std::uint64_t bins = std::max<std::uint64_t>(room_for_boxes(plan), first.bins.size());
    const std::uint64_t samples = room_for_entries(plan) * kBytesPerEntry;
    const std::uint64_t triangles = first.triangles.size() * kBytesPerTriangle;
    const std::uint64_t near = (first.near.size() + 3 * first.blocks()) * sizeof(std::uint32_t);
    return {bins * kSpaceBytesPerBin + samples + triangles + near + round * kSpaceBytesPerDraw,
            std::max({bins * 16, samples, triangles, near, round * 16})};
}

Needs needs_of(const Plan& plan, std::uint64_t round) {
    if (plan.is_space()) return needs_of_space(plan, round);
    if (plan.has_radius_field()) return needs_of_field(plan, round);
    return plan.is_cells() ? needs_of_cells(plan, round) : needs_of_lines(plan, round);
}

}  // namespace

std::uint64_t room_for_boxes(const Plan& plan) {
    const double of_sample = plan.is_space()           ? most_in_space(plan).bins
                             : plan.has_radius_field() ? kFieldBoxesPerSample
                                                       : kBoxesPerSample;
    return static_cast<std::uint64_t>(of_sample * static_cast<double>(plan.expected_samples));
}

std::uint64_t room_for_entries(const Plan& plan) {
    const std::uint64_t of_sample =
        plan.is_space() ? most_in_space(plan).entries : kEntriesPerSample;
    return of_sample * plan.expected_samples;
}

void refuse_if_too_large(const std::string& device, const Plan& plan, std::uint64_t memory_bytes,
                         std::uint64_t largest_buffer_bytes) {
    // A table's indices have 32 bits.
    const std::uint64_t most_draws = std::min<std::uint64_t>(
        largest_buffer_bytes / kLargestPerDraw, std::numeric_limits<std::uint32_t>::max() / 3);
    if (plan.round_size > most_draws)
        throw BadRequest("round-size", std::to_string(plan.round_size),
                         "must be at most " + std::to_string(most_draws) + " on " + device +
                             ", whose largest buffer has " + gigabytes(largest_buffer_bytes));
    // Rounds have been seen to double once after the first; largest_round_size bounds them.
    const std::uint64_t first = first_round_size(plan);
    const std::uint64_t round =
        plan.round_size != 0 ? first : std::min(2 * first, largest_round_size(plan));
    refuse_if_too_large(device, needs_of(plan, round), memory_bytes, largest_buffer_bytes);
}

void refuse_if_too_large(const std::string& device, const Needs& needs, std::uint64_t memory_bytes,
                         std::uint64_t largest_buffer_bytes) {
    if (needs.largest > largest_buffer_bytes)
        throw Unavailable("device " + device + ": the request needs a buffer of " +
                          gigabytes(needs.largest) + ", and its largest has " +
                          gigabytes(largest_buffer_bytes));
    if (needs.bytes > memory_bytes)
        throw Unavailable("device " + device + ": the request needs " + gigabytes(needs.bytes) +
                          " of memory, and it has " + gigabytes(memory_bytes));
}

}  // namespace lacuna::device
