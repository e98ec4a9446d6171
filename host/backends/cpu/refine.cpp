// refine: cuts the bins by all samples near them into boxes (docs/design.md, section 4, "exact").
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "backends/cpu/chords.h"
#include "backends/cpu/state.h"
#include "backends/cpu/vectors.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

class GridCut {
public:
    GridCut(const SpanState& state, std::uint32_t width)
        : state_(state),
          vectors_(vectors_for(state.plan.radius)),
          width_(width),
          own_(state.plan.own_x()) {}

    // Cuts a box, as wide as the bins were, into strips of the new width and appends their pieces.
    // A box in the halo stays as it is.
    void cut(Box box, std::vector<Box>& left) {
        if (box.x - own_.begin >= own_.end - own_.begin) return left.push_back(box);
        near_count_ = 0;
        // Every cell is written, but only samples raise the count, so that there is no branch.
        state_.grid->for_each_cell_near(box.x, box.x + state_.bin_width, box.begin, box.end,
                                        [&](Sample cell) {
                                            near_[near_count_] = cell;
                                            near_count_ += cell.x != NO_SAMPLE;
                                        });
        for (std::uint32_t x = box.x; x < box.x + state_.bin_width; x += width_)
            cut_strip({x, width_, box.begin, box.end}, left);
    }
    // The same for a span, which is first cut where rows of cells end.
    void cut(std::uint32_t x, Span span, std::vector<Box>& left) {
        const std::uint32_t side = state_.plan.grid().side;
        while (span.begin < span.end) {
            const std::uint32_t row_end =
                std::min(span.end - span.begin, side - span.begin % side) + span.begin;
            cut({x, state_.bin_width, span.begin, row_end}, left);
            span.begin = row_end;
        }
    }

private:
    // The distance in x to the far edge of the strip around `centre`.
    std::uint32_t distance_to(Sample sample, std::uint32_t centre) const {
        return portable::axis_distance(sample.x, centre, state_.plan.period_x) + width_ / 2;
    }

    // Most strips are covered by one sample, and most samples near a strip do not touch it. Squared
    // distances show both, so that square roots are taken for the rest only.
    void cut_strip(const Box& box, std::vector<Box>& left) {
        const std::uint64_t radius_squared = state_.plan.radius_squared;
        const std::uint32_t centre = box.x + width_ / 2;
        std::size_t count = 0;
        bool is_covered = false;
        for (const Sample sample : std::span(near_).first(near_count_)) {
            const std::uint32_t dx = distance_to(sample, centre);
            const std::uint32_t y = sample.y;
            is_covered |= portable::squared_length(dx, portable::farthest_distance(
                                                           y, box.begin, box.end)) < radius_squared;
            touching_[count] = {dx, y};
            count += portable::squared_length(
                         dx, portable::nearest_distance(y, box.begin, box.end)) < radius_squared;
        }
        if (is_covered) return;
        sort_chords(box, count);
        for_each_piece({box.begin, box.end}, std::span(chords_).first(chord_count_),
                       [&](std::uint32_t begin, std::uint32_t end) {
                           left.push_back({box.x, width_, begin, end});
                       });
    }

    // Finds and sorts the chords of the first `count` samples in touching_.
    void sort_chords(const Box& strip, std::size_t count) {
        const Plan& plan = state_.plan;
        vectors_.find_chords(std::span(touching_).first(count), plan.radius_squared, plan.height,
                             found_.data());
        chord_count_ = 0;
        for (const Span chord : std::span(found_).first(count)) add_chord(chord);
        if (plan.period_y != 0 &&
            (strip.begin < plan.radius || strip.end + plan.radius > plan.height))
            add_wrapped_chords(strip.x + width_ / 2);
    }

    // A chord that sticks out at one end of a torus is cut at the other end.
    void add_wrapped_chords(std::uint32_t centre) {
        const Plan& plan = state_.plan;
        Span bottom{0, 0};
        Span top{plan.height, plan.height};
        for (const Sample sample : std::span(near_).first(near_count_)) {
            const std::uint32_t y = sample.y;
            const std::uint32_t reach =
                portable::chord_reach(distance_to(sample, centre), plan.radius_squared);
            bottom.end = std::max(bottom.end, portable::window_end(2, y, reach, plan.height));
            top.begin = std::min(top.begin, portable::window_begin(1, y, reach, plan.height));
        }
        add_chord(bottom);
        add_chord(top);
    }

    void add_chord(Span chord) {
        chords_[chord_count_++] = chord;
        sort_in_last(chords_.data(), chord_count_);
    }

    // Room for the samples near a box. A box and a radius around it reach over at most 7 x 6 cells,
    // where cells at the edge of a torus may count twice.
    static constexpr std::size_t kMost = 64;

    const SpanState& state_;
    const Vectors& vectors_;
    std::uint32_t width_;
    Span own_;  // the interval of x outside the halo
    std::array<Sample, kMost> near_;
    std::size_t near_count_ = 0;
    std::array<Seen, kMost + kVectorPadding> touching_;
    std::array<Span, kMost + kVectorPadding> found_;
    std::array<Span, kMost + 2> chords_;  // two more for a torus
    std::size_t chord_count_ = 0;
};

constexpr std::size_t kBoxesAhead = 4;  // prefetch distance; 4 to 8 are equally fast

void refine_boxes(const SpanState& state, std::span<const Box> boxes, GridCut& cut,
                  std::vector<Box>& left) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Box& later = boxes[std::min(k + kBoxesAhead, boxes.size() - 1)];
        state.grid->fetch_near(later.x, later.begin);
        cut.cut(boxes[k], left);
    }
}

void refine_line(const SpanState& state, std::uint32_t line, GridCut& cut, std::vector<Box>& left) {
    const std::uint32_t x = line * state.plan.strip_width;
    const std::span<const Span> spans = state.slot(line).first(state.span_counts[line]);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        state.grid->fetch_near(x, spans[std::min(k + kBoxesAhead, spans.size() - 1)].begin);
        cut.cut(x, spans[k], left);
    }
}

}  // namespace

void insert(SpanState& state, std::uint32_t column) {
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i)
        if (state.statuses[i] == STATUS_ADMITTED)
            state.grid->insert({state.candidates[i].x, state.candidates[i].y});
}

void refine(SpanState& state, std::uint32_t column, std::uint32_t width) {
    thread_local std::vector<Box> of_thread;
    std::vector<Box>& left = of_thread;  // looked up once, see subtract.cpp
    left.clear();
    GridCut cut(state, width);
    if (state.has_boxes) {
        refine_boxes(state, state.boxes[column], cut, left);
    } else {
        for (std::uint32_t i = state.first_lines[column]; i < state.first_lines[column + 1]; ++i)
            refine_line(state, i, cut, left);
    }
    state.boxes[column] = std::vector<Box>(left.begin(), left.end());
}

}  // namespace lacuna::cpu
