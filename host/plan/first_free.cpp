// Computes what is free before the first sample.
#include "plan/first_free.h"

#include <algorithm>
#include <cstddef>

#include "plan/first_boxes.h"
#include "portable/bits.h"
#include "space/first_bins.h"

namespace lacuna {
namespace {

// In cells, lines above one column of pixels have equal spans; in the other modes all have.
bool is_like_the_line_below(const Plan& plan, std::uint32_t line) {
    return !plan.is_cells() ||
           plan.cells().radii->column_of[line] == plan.cells().radii->column_of[line - 1];
}

}  // namespace

std::vector<Span> first_spans(const Plan& plan, std::uint32_t line) {
    if (!plan.is_cells()) return {{0, plan.height}};
    const RadiusMap& map = *plan.cells().radii;
    const std::uint32_t* const radii = &map.radii[std::size_t{map.column_of[line]} * map.rows];
    std::vector<Span> spans;
    for (std::uint32_t row = 0; row < map.rows;) {
        const std::uint32_t first = row;
        while (row < map.rows && radii[row] != 0) ++row;
        const Span above = {map.row_begins[first], map.row_begins[row]};
        while (row < map.rows && radii[row] == 0) ++row;
        if (above.begin == above.end) continue;
        // Rows of pixels without importance may be so low that no lattice point lies on them.
        if (!spans.empty() && spans.back().end == above.begin)
            spans.back().end = above.end;
        else
            spans.push_back(above);
    }
    return spans;
}

std::vector<std::uint32_t> first_free_lengths(const Plan& plan) {
    std::vector<std::uint32_t> lengths(plan.lines, 0);
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        if (line > 0 && is_like_the_line_below(plan, line))
            lengths[line] = lengths[line - 1];
        else
            for (const Span span : first_spans(plan, line)) lengths[line] += span.end - span.begin;
    }
    return lengths;
}

FirstFree::FirstFree(const Plan& plan) {
    if (plan.is_space()) {
        const space::FirstBins& all = *plan.space().first_bins;
        for (std::uint32_t block = 0; block < all.blocks(); ++block)
            for (std::uint32_t i = all.begins[block]; i < all.begins[block + 1]; ++i) {
                const auto [length, width] = space::size_of(all.weight_of(all.bins[i], block));
                lengths.push_back(length);
                widths.push_back(width);
            }
        return;
    }
    if (!plan.has_radius_field()) {
        lengths = first_free_lengths(plan);
        return;
    }
    const std::vector<Box>& boxes = plan.field().first_boxes->boxes;
    lengths.reserve(boxes.size());
    widths.reserve(boxes.size());
    for (const Box& box : boxes) {
        lengths.push_back(box.end - box.begin);
        widths.push_back(box.width);
    }
    copy_ends = copy_ends_of(plan, boxes);
}

std::vector<std::uint32_t> copy_ends_of(const Plan& plan, std::span<const Box> boxes) {
    const ClassCopies& copies = plan.field().copies;
    std::vector<std::uint32_t> ends;
    for (std::uint32_t copy = 0; copies.are_several() && copy < copies.count(); ++copy) {
        const auto end = std::partition_point(
            boxes.begin(), boxes.end(), [&](const Box& box) { return copies.of(box.x) <= copy; });
        ends.push_back(static_cast<std::uint32_t>(end - boxes.begin()));
    }
    return ends;
}

std::uint32_t words_per_line(const Plan& plan) {
    return 2 * ((plan.height + 63) / 64);
}

std::vector<std::uint32_t> first_bits(const Plan& plan, std::uint32_t first_line,
                                      std::uint32_t end_line) {
    const std::size_t words = words_per_line(plan);
    std::vector<std::uint32_t> bits(words * (end_line - first_line));
    for (std::uint32_t line = first_line; line < end_line; ++line) {
        std::uint32_t* const of_line = &bits[words * (line - first_line)];
        if (line > first_line && is_like_the_line_below(plan, line)) {
            std::copy(of_line - words, of_line, of_line);
            continue;
        }
        for (const Span span : first_spans(plan, line))
            for (std::uint32_t word = span.begin / 32; word <= (span.end - 1) / 32; ++word)
                of_line[word] |= portable::word_mask(word, span.begin, span.end);
    }
    return bits;
}

}  // namespace lacuna
