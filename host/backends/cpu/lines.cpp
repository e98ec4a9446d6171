// Memory of the free spans of lines, which are cut in subtract.cpp, and the bins of mode lines.
#include "backends/cpu/lines.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "backends/columns.h"
#include "backends/cpu/sorted_bins.h"
#include "base/large_pages.h"
#include "plan/first_free.h"

namespace lacuna::cpu {
namespace {

struct SpansOfLine {
    const Lines& lines;
    const Span* first_of(std::uint32_t line) const { return lines.spans_of(line).data(); }
    std::uint32_t length(const Span* span) const { return span->end - span->begin; }
    std::uint32_t y_at(std::uint32_t, const Span* span, std::uint32_t rank) const {
        return span->begin + rank;
    }
};

class LineBins : public SortedBins {
public:
    LineBins(const Plan& plan, Workers& workers) : SortedBins(plan, workers), lines_(plan) {}

    void set_free() override {
        for_columns(round.plan.lines, [&](std::uint32_t column) { lines_.set_free(column); });
    }
    void locate(std::span<const Draw> draws) override {
        locate_columns([&](std::uint32_t column) { lines_.locate(draws, column, round); });
    }
    bool admit() override { return admit_on_lines(*this, workers_); }
    void subtract() override { lines_.subtract(round, workers_, free_lengths); }
    bool is_covered(const Candidate& candidate) const override {
        const std::span<const Span> spans = lines_.spans_of(candidate.home);
        const auto above = std::partition_point(
            spans.begin(), spans.end(), [&](const Span& span) { return span.end <= candidate.y; });
        return above == spans.end() || above->begin > candidate.y;
    }

    Snapshot snapshot(std::span<const Sample> left_out) const override {
        Snapshot snapshot = Bins::snapshot(left_out);
        lines_.snapshot(snapshot);
        return snapshot;
    }
    void restore(const Snapshot& snapshot) override {
        SortedBins::restore(snapshot);
        free_lengths = lines_.restore(snapshot);
    }

private:
    Lines lines_;
};

}  // namespace

Lines::Lines(const Plan& plan)
    : plan_(plan),
      first_lines_(lacuna::first_lines(plan, count_columns(plan))),
      span_counts_(plan.lines) {
    make_room(first_capacity(plan));
}

void Lines::make_room(std::uint32_t capacity) {
    capacity_ = capacity;
    spans_ = std::make_unique_for_overwrite<Span[]>(std::size_t{plan_.lines} * capacity);
    ask_for_large_pages(spans_.get(), std::size_t{plan_.lines} * capacity);
}

void Lines::set_spans(std::uint32_t line, std::span<const Span> of_line) {
    std::copy(of_line.begin(), of_line.end(), slot(line));
    span_counts_[line] = static_cast<std::uint32_t>(of_line.size());
}

void Lines::grow() {
    const std::unique_ptr<Span[]> old = std::move(spans_);
    const std::size_t old_capacity = capacity_;
    make_room(2 * capacity_);
    for (std::uint32_t line = 0; line < plan_.lines; ++line)
        set_spans(line, {&old[line * old_capacity], span_counts_[line]});
}

void Lines::set_free(std::uint32_t column) {
    for (std::uint32_t line = first_lines_[column]; line < first_lines_[column + 1]; ++line)
        set_spans(line, first_spans(plan_, line));
}

void Lines::locate(std::span<const Draw> draws, std::uint32_t column, RoundMemory& round) const {
    round.locate_on_lines(draws, column, SpansOfLine{*this});
}

void Lines::subtract(const RoundMemory& round, Workers& workers,
                     std::vector<std::uint32_t>& free_lengths) {
    while (!workers.all_columns(round.columns, round.candidates.size(), [&](std::uint32_t column) {
        return subtract(round, column, free_lengths);
    }))
        grow();
}

void Lines::snapshot(Snapshot& snapshot) const {
    snapshot.capacity = capacity_;
    for (std::uint32_t line = 0; line < plan_.lines; ++line) {
        const std::span<const Span> spans = spans_of(line);
        snapshot.spans.emplace_back(spans.begin(), spans.end());
    }
}

std::vector<std::uint32_t> Lines::restore(const Snapshot& snapshot) {
    make_room(snapshot.capacity);
    std::vector<std::uint32_t> free_lengths(plan_.lines, 0);
    for (std::uint32_t line = 0; line < plan_.lines; ++line) {
        set_spans(line, snapshot.spans[line]);
        for (const Span span : snapshot.spans[line]) free_lengths[line] += span.end - span.begin;
    }
    return free_lengths;
}

std::unique_ptr<Bins> make_line_bins(const Plan& plan, Workers& workers) {
    return std::make_unique<LineBins>(plan, workers);
}

}  // namespace lacuna::cpu
