// Mode lines (section 4.1): a candidate is free where its own line is.
#include "backends/reference/lines.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "backends/reference/free_space.h"
#include "base/polling.h"
#include "plan/first_free.h"
#include "portable/stretch.h"

namespace lacuna::reference {
namespace {

class Lines : public FreeSpace {
public:
    explicit Lines(const Plan& plan) : plan_(plan), spans_(plan) {}

    std::span<const std::uint32_t> free_lengths() const override { return spans_.lengths(); }
    std::uint32_t bin_width() const override { return plan_.strip_width; }
    Sample at(std::uint32_t line, std::uint32_t rank, std::uint32_t offset) const override {
        return {line * plan_.strip_width + offset, spans_.y_at_rank(line, rank)};
    }
    bool is_free(Sample candidate) const override {
        return spans_.is_free(plan_.line_of(candidate), candidate.y);
    }
    void add(Sample sample) override { spans_.subtract_disk(sample); }

private:
    const Plan& plan_;
    FreeSpans spans_;
};

}  // namespace

std::unique_ptr<FreeSpace> make_lines(const Plan& plan) {
    return std::make_unique<Lines>(plan);
}

FreeSpans::FreeSpans(const Plan& plan) : plan_(plan), lengths_(first_free_lengths(plan)) {
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        ask_after();
        spans_.push_back(first_spans(plan, line));
    }
}

std::uint32_t FreeSpans::y_at_rank(std::uint32_t line, std::uint32_t rank) const {
    for (const Span& span : spans_[line]) {
        const std::uint32_t length = span.end - span.begin;
        if (rank < length) return span.begin + rank;
        rank -= length;
    }
    assert(false);
    return 0;
}

bool FreeSpans::is_free(std::uint32_t line, std::uint32_t y) const {
    const std::vector<Span>& spans = spans_[line];
    const auto span = std::partition_point(spans.begin(), spans.end(),
                                           [&](const Span& each) { return each.end <= y; });
    return span != spans.end() && span->begin <= y;
}

void FreeSpans::subtract_disk(Sample sample) {
    const portable::Stretch near = portable::stretch_around(
        plan_.line_of(sample), plan_.radius / plan_.strip_width + 1, plan_.lines, plan_.period_x);
    for (std::uint32_t i = 0; i < near.count; ++i) {
        ask_after();
        const std::uint32_t line = portable::nth_of_stretch(near, i, plan_.lines);
        for_each_chord(plan_, sample, plan_.centre_of_line(line), plan_.chord_margin(),
                       [&](Span chord) { subtract(line, chord); });
    }
}

void FreeSpans::subtract(std::uint32_t line, Span chord) {
    std::vector<Span>& spans = spans_[line];
    const auto first = std::partition_point(
        spans.begin(), spans.end(), [&](const Span& span) { return span.end <= chord.begin; });
    const auto last = std::partition_point(
        first, spans.end(), [&](const Span& span) { return span.begin < chord.end; });
    if (first == last) return;

    // Cuts only the free parts of the chord, so that nothing is counted twice.
    Span pieces[2];
    int count = 0;
    if (first->begin < chord.begin) pieces[count++] = {first->begin, chord.begin};
    if (std::prev(last)->end > chord.end) pieces[count++] = {chord.end, std::prev(last)->end};
    for (auto span = first; span != last; ++span) lengths_[line] -= span->end - span->begin;
    for (int i = 0; i < count; ++i) lengths_[line] += pieces[i].end - pieces[i].begin;
    spans.insert(spans.erase(first, last), pieces, pieces + count);
}

}  // namespace lacuna::reference
