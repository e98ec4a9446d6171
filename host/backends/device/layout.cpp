// The layout of a plan's memory on a device.
#include "backends/device/layout.h"

#include <algorithm>
#include <limits>

#include "backends/columns.h"
#include "base/number_text.h"
#include "plan/first_boxes.h"
#include "plan/first_free.h"
#include "plan/radius_field.h"
#include "portable/column.h"
#include "portable/status.h"
#include "rounds/round_policy.h"

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
    if (plan.has_field() && plan.field().radius_field->has_ellipses()) return RULE_OF_ELLIPSES;
    return plan.is_exact() ? RULE_OF_DISKS : RULE_OF_LINES;
}

}  // namespace

portable::Geometry geometry_of(const Plan& plan, std::uint32_t columns, std::uint32_t capacity) {
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
            .grid_side = plan.grid().side,
            .grid_columns = plan.grid().columns,
            .grid_rows = plan.grid().rows,
            .sheet_bits = plan.has_field() ? plan.field().sheets.bits() : BITS_OF_ONE_SHEET};
}

Range draws_of(const Slab& slab, std::span<const Draw> draws) {
    const auto index_of_line = [&](std::uint32_t line) {
        const auto first = std::partition_point(draws.begin(), draws.end(),
                                                [&](const Draw& draw) { return draw.bin < line; });
        return static_cast<std::uint32_t>(first - draws.begin());
    };
    return {index_of_line(slab.first_line), index_of_line(slab.end_line)};
}

void find_near_begins(const Plan& plan, std::uint32_t columns,
                      std::span<const std::uint32_t> column_begins,
                      std::vector<std::uint32_t>& begins) {
    begins.resize(columns + std::size_t{1});
    begins[0] = 0;
    for (std::uint32_t column = 0; column < columns; ++column) {
        const portable::Stretch near = portable::stretch_around(column, 1, columns, plan.period_x);
        begins[column + 1] = begins[column];
        for (std::uint32_t k = 0; k < near.count; ++k) {
            const std::uint32_t neighbour = portable::nth_of_stretch(near, k, columns);
            begins[column + 1] += column_begins[neighbour + 1] - column_begins[neighbour];
        }
    }
}

std::uint64_t take_admitted(std::span<const Sample> by_order, std::vector<Sample>& samples) {
    samples.clear();
    std::uint64_t survivors = 0;
    for (const Sample& sample : by_order) {
        const bool admitted = sample.x != NO_SAMPLE;
        if (admitted) samples.push_back(sample);
        survivors += admitted || sample.y != STATUS_COVERED;
    }
    return survivors;
}

std::vector<Sample> samples_by_order(const Snapshot& snapshot) {
    std::vector<Sample> samples(snapshot.candidates.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Candidate& candidate = snapshot.candidates[i];
        samples[candidate.order] = snapshot.statuses[i] == STATUS_ADMITTED
                                       ? Sample{candidate.x, candidate.y}
                                       : Sample{NO_SAMPLE, snapshot.statuses[i]};
    }
    return samples;
}

std::vector<Span> pack(const Slab& slab, const Snapshot& snapshot) {
    std::vector<Span> slots(std::size_t{slab.lines()} * snapshot.capacity);
    for (std::uint32_t i = 0; i < slab.lines(); ++i) {
        const std::vector<Span>& spans = snapshot.spans[slab.first_line + i];
        std::copy(spans.begin(), spans.end(),
                  slots.begin() + static_cast<std::ptrdiff_t>(std::size_t{i} * snapshot.capacity));
    }
    return slots;
}

void unpack(const Slab& slab, std::span<const Span> slots,
            std::span<const std::uint32_t> span_counts, Snapshot& snapshot) {
    for (std::uint32_t i = 0; i < slab.lines(); ++i) {
        const auto spans =
            slots.subspan(std::size_t{i} * snapshot.capacity, span_counts[slab.first_line + i]);
        snapshot.spans.emplace_back(spans.begin(), spans.end());
    }
}

namespace {

std::string gigabytes(std::uint64_t bytes) {
    return rounded(static_cast<double>(bytes) / 1e9, 3) + " GB";
}

// Bytes of a draw: draws, located, candidates; buckets, statuses; samples; three entries of near.
constexpr std::uint64_t kBytesPerDraw = 48 + 8 + 8 + 24;
constexpr std::uint64_t kLargestPerDraw = 24;  // of the largest buffer, near

// In exact, bytes of a cell; and of a box: itself before and after a round, the pieces of its two
// strips, its length and its count.
constexpr std::uint64_t kBytesPerCell = 8;
constexpr std::uint64_t kBytesPerBox = 2 * 16 + 2 * 8 + 2 * 4;
// Most boxes for each sample of the maximal set: 0.45 to 0.5 have been seen.
constexpr double kBoxesPerSample = 0.75;

Needs needs_of_lines(const Plan& plan, std::uint64_t round) {
    const std::uint64_t line_bytes = std::uint64_t{first_capacity(plan)} * sizeof(Span);
    // Cells and boxes have a buffer for each coordinate.
    const std::uint64_t cells =
        plan.is_exact() ? std::uint64_t{plan.grid().columns} * plan.grid().rows : 0;
    const auto boxes = static_cast<std::uint64_t>(
        plan.is_exact() ? kBoxesPerSample * static_cast<double>(plan.expected_samples) : 0);
    return {plan.lines * (line_bytes + 8) + round * kBytesPerDraw + cells * kBytesPerCell +
                boxes * kBytesPerBox,
            std::max({line_bytes, plan.lines * std::uint64_t{4}, round * kLargestPerDraw,
                      cells * kBytesPerCell / 2, boxes * 16})};
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

Needs needs_of(const Plan& plan, std::uint64_t round) {
    if (plan.has_field()) return needs_of_field(plan, round);
    return plan.is_cells() ? needs_of_cells(plan, round) : needs_of_lines(plan, round);
}

}  // namespace

std::uint64_t room_for_boxes(const Plan& plan) {
    const double of_sample = plan.has_field() ? kFieldBoxesPerSample : kBoxesPerSample;
    return static_cast<std::uint64_t>(of_sample * static_cast<double>(plan.expected_samples));
}

std::uint64_t room_for_entries(const Plan& plan) {
    return kEntriesPerSample * plan.expected_samples;
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
