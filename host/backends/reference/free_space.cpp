// The free spans of every line, and the subtraction of a disk from them.
#include "backends/reference/free_space.h"

#include <algorithm>
#include <cassert>

#include "portable/chord.h"
#include "portable/distance.h"

namespace lacuna::reference {

FreeSpace::FreeSpace(const Plan& plan)
    : plan_(plan),
      spans_(plan.lines, {Span{0, plan.height}}),
      free_lengths_(plan.lines, plan.height) {}

std::uint32_t FreeSpace::y_at_rank(std::uint32_t line, std::uint32_t rank) const {
    for (const Span& span : spans_[line]) {
        const std::uint32_t length = span.end - span.begin;
        if (rank < length) return span.begin + rank;
        rank -= length;
    }
    assert(false);
    return 0;
}

bool FreeSpace::is_free(std::uint32_t line, std::uint32_t y) const {
    const std::vector<Span>& spans = spans_[line];
    const auto span = std::partition_point(spans.begin(), spans.end(),
                                           [&](const Span& each) { return each.end <= y; });
    return span != spans.end() && span->begin <= y;
}

void FreeSpace::subtract_disk(Sample sample) {
    // The lines that may cross it: those whose strips lie within the radius, taken modulo the
    // width on a torus.
    const std::int64_t reach = plan_.radius / plan_.strip_width + 1;
    const std::int64_t line_count = plan_.lines;
    const std::int64_t home = plan_.line_of(sample);
    const bool wraps = plan_.period_x != 0;
    const bool all = wraps && 2 * reach + 1 >= line_count;
    const std::int64_t first = all || (!wraps && home < reach) ? 0 : home - reach;
    const std::int64_t last =
        all || (!wraps && home + reach >= line_count) ? line_count - 1 : home + reach;

    for (std::int64_t i = first; i <= last; ++i) {
        const auto line = static_cast<std::uint32_t>((i + line_count) % line_count);
        const std::uint32_t dx =
            portable::axis_distance(sample.x, plan_.centre_of_line(line), plan_.period_x);
        const std::int64_t half =
            portable::chord_reach(dx + plan_.chord_margin(), plan_.radius_squared);
        if (half == 0) continue;
        const std::int64_t y = sample.y;
        const std::int64_t period = plan_.period_y;
        subtract_chord(line, y - half + 1, y + half);
        if (period == 0) continue;
        subtract_chord(line, y - half + 1 + period, y + half + period);
        subtract_chord(line, y - half + 1 - period, y + half - period);
    }
}

void FreeSpace::subtract_chord(std::uint32_t line, std::int64_t begin, std::int64_t end) {
    if (end <= 0 || begin >= plan_.height) return;
    const auto low = static_cast<std::uint32_t>(std::max<std::int64_t>(begin, 0));
    const auto high = static_cast<std::uint32_t>(std::min<std::int64_t>(end, plan_.height));

    std::vector<Span>& spans = spans_[line];
    const auto first = std::partition_point(spans.begin(), spans.end(),
                                            [&](const Span& span) { return span.end <= low; });
    const auto last = std::partition_point(first, spans.end(),
                                           [&](const Span& span) { return span.begin < high; });
    if (first == last) return;

    // Only what lies in the free space is subtracted, so that nothing is counted twice.
    Span pieces[2];
    int count = 0;
    if (first->begin < low) pieces[count++] = {first->begin, low};
    if (std::prev(last)->end > high) pieces[count++] = {high, std::prev(last)->end};
    for (auto span = first; span != last; ++span) free_lengths_[line] -= span->end - span->begin;
    for (int i = 0; i < count; ++i) free_lengths_[line] += pieces[i].end - pieces[i].begin;
    spans.insert(spans.erase(first, last), pieces, pieces + count);
}

}  // namespace lacuna::reference
