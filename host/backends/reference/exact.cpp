// Mode exact: bins that hold all of the free space, candidates that count only where they are truly
// free, and ever finer boxes until no box is left (docs/design.md, section 4).
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "backends/reference/free_space.h"
#include "backends/reference/lines.h"
#include "portable/distance.h"

namespace lacuna::reference {
namespace {

// All samples, in square cells (Bins) at least a radius wide, so that everything near a point lies
// in its own cell or in one beside it.
class Samples {
public:
    explicit Samples(const Plan& plan)
        : plan_(plan),
          columns_(std::max(1u, plan.width / plan.radius)),
          rows_(std::max(1u, plan.height / plan.radius)),
          bins_(std::size_t{columns_} * rows_) {}

    void add(Sample sample) { bin(column_of(sample.x), row_of(sample.y)).push_back(sample); }

    bool is_covered(Sample place) const {
        bool covered = false;
        for_each_near(place, [&](Sample sample) {
            covered |= portable::are_closer(sample.x, sample.y, place.x, place.y, plan_.period_x,
                                            plan_.period_y, plan_.radius_squared);
        });
        return covered;
    }

    // Visits all samples within two radii of `place`, and others; on a small torus some twice.
    template <typename Visit>
    void for_each_near(Sample place, Visit visit) const {
        for (std::int64_t i = -2; i <= 2; ++i) {
            for (std::int64_t j = -2; j <= 2; ++j) {
                const auto column = shifted(column_of(place.x), i, columns_, plan_.period_x != 0);
                const auto row = shifted(row_of(place.y), j, rows_, plan_.period_y != 0);
                if (column < 0 || row < 0) continue;
                const auto index = static_cast<std::size_t>(column * rows_ + row);
                for (const Sample sample : bins_[index]) visit(sample);
            }
        }
    }

private:
    std::uint32_t column_of(std::uint32_t x) const {
        return static_cast<std::uint32_t>(std::uint64_t{x} * columns_ / plan_.width);
    }
    std::uint32_t row_of(std::uint32_t y) const {
        return static_cast<std::uint32_t>(std::uint64_t{y} * rows_ / plan_.height);
    }
    std::vector<Sample>& bin(std::uint32_t column, std::uint32_t row) {
        return bins_[std::size_t{column} * rows_ + row];
    }
    // -1 beyond the edge of a box.
    static std::int64_t shifted(std::int64_t index, std::int64_t by, std::int64_t count,
                                bool wraps) {
        const std::int64_t there = index + by;
        if (wraps) return (there % count + count) % count;
        return there < count ? there : -1;
    }

    const Plan& plan_;
    std::uint32_t columns_;
    std::uint32_t rows_;
    std::vector<std::vector<Sample>> bins_;
};

// Lines with free spans at first, boxes after the first refinement.
class Exact : public FreeSpace {
public:
    explicit Exact(const Plan& plan)
        : plan_(plan), samples_(plan), spans_(plan), width_(plan.strip_width) {}

    std::span<const std::uint32_t> free_lengths() const override {
        return are_boxes_ ? box_lengths_ : spans_.lengths();
    }
    std::uint32_t bin_width() const override { return width_; }
    Sample at(std::uint32_t place, std::uint32_t rank, std::uint32_t offset) const override {
        if (are_boxes_) return {boxes_[place].x + offset, boxes_[place].begin + rank};
        return {place * plan_.strip_width + offset, spans_.y_at_rank(place, rank)};
    }
    bool is_free(Sample candidate) const override { return !samples_.is_covered(candidate); }
    void add(Sample sample) override { samples_.add(sample); }
    void end_round(std::span<const Sample> samples, const RoundPolicy& policy) override {
        if (policy.refines())
            refine(policy.halves());
        else
            for (const Sample sample : samples) spans_.subtract_disk(sample);
    }

private:
    void refine(bool halve) {
        const std::vector<Box> old = are_boxes_ ? std::move(boxes_) : boxes_of_lines();
        const std::uint32_t width = halve ? width_ / 2 : width_;
        boxes_.clear();
        for (const Box box : old)
            for (std::uint32_t x = box.x; x < box.x + width_; x += width)
                append_remnants({x, box.begin, box.end}, width);
        box_lengths_.clear();
        for (const Box box : boxes_) box_lengths_.push_back(box.end - box.begin);
        width_ = width;
        are_boxes_ = true;
    }

    // Free spans as boxes, which end where a row of the sample grid does.
    std::vector<Box> boxes_of_lines() const {
        std::vector<Box> all;
        for (std::uint32_t line = 0; line < plan_.lines; ++line) {
            for (const Span span : spans_.of_line(line)) {
                for (std::uint32_t begin = span.begin; begin < span.end;) {
                    const std::uint32_t row_end = begin - begin % plan_.grid_side + plan_.grid_side;
                    const std::uint32_t end = std::min(span.end, row_end);
                    all.push_back({line * plan_.strip_width, begin, end});
                    begin = end;
                }
            }
        }
        return all;
    }

    // Appends the pieces of the strip after all samples' chords are cut from it. A chord covers the
    // strip's whole width: it is cut at the far edge.
    void append_remnants(Box strip, std::uint32_t width) {
        std::vector<Span> chords;
        const std::uint32_t centre = strip.x + width / 2;
        samples_.for_each_near({centre, strip.begin}, [&](Sample sample) {
            for_each_chord(plan_, sample, centre, width / 2,
                           [&](Span chord) { chords.push_back(chord); });
        });
        chords.push_back({strip.end, strip.end});
        std::sort(chords.begin(), chords.end(), [](Span a, Span b) { return a.begin < b.begin; });
        std::uint32_t free_from = strip.begin;
        for (const Span chord : chords) {
            const std::uint32_t free_to = std::min(chord.begin, strip.end);
            if (free_from < free_to) boxes_.push_back({strip.x, free_from, free_to});
            free_from = std::max(free_from, chord.end);
        }
    }

    const Plan& plan_;
    Samples samples_;
    FreeSpans spans_;
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> box_lengths_;
    std::uint32_t width_;
    bool are_boxes_ = false;
};

}  // namespace

std::unique_ptr<FreeSpace> make_exact(const Plan& plan) {
    return std::make_unique<Exact>(plan);
}

}  // namespace lacuna::reference
