// The bins of mode exact with one radius: the free spans of lines and, from the first refinement
// on, active boxes of one width.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "backends/columns.h"
#include "backends/cpu/boxes.h"
#include "backends/cpu/lines.h"
#include "backends/cpu/one_radius.h"
#include "plan/first_free.h"

namespace lacuna::cpu {
namespace {

class UniformBoxes : public Boxes<SampleGrid> {
public:
    UniformBoxes(const Plan& plan, Workers& workers)
        : Boxes(plan, workers, count_columns(plan)), width_(plan.strip_width), lines_(plan) {
        begins = lines_->first_lines();
        free_lengths = first_free_lengths(plan);
    }

    void set_free() override {
        for_columns(round.plan.lines, [&](std::uint32_t column) {
            lines_->set_free(column);
            index_.clear(column, round.columns);
        });
    }
    void locate(std::span<const Draw> draws) override {
        if (!lines_) return Boxes::locate(draws);
        for_columns(draws.size(), [&](std::uint32_t column) {
            lines_->locate(draws, column, round);
            end_locate(column);
        });
    }
    void subtract() override { lines_.value().subtract(round, workers_, free_lengths); }

    void refine(bool halve) override {
        if (halve) width_ /= 2;
        if (!lines_) return Boxes::refine(halve);
        for_columns(begins.back(), [&](std::uint32_t column) {
            turn_into_boxes(column);
            refine_column(column, halve);
        });
        lines_.reset();
        settle();
    }
    std::uint32_t width() const override { return width_; }

    Snapshot snapshot(std::span<const Sample> left_out) const override {
        Snapshot snapshot = Boxes::snapshot(left_out);
        if (lines_)
            lines_->snapshot(snapshot);
        else
            snapshot.box_width = width_;
        return snapshot;
    }
    void restore(const Snapshot& snapshot) override {
        Boxes::restore(snapshot);
        lines_.reset();
        width_ = snapshot.box_width;
        if (width_ != 0) return;
        width_ = round.plan.strip_width;
        lines_.emplace(round.plan);
        begins = lines_->first_lines();
        free_lengths = lines_->restore(snapshot);
    }

private:
    void refine_column(std::uint32_t column, bool halve) override {
        refine_by<OneRadius>(column, halve);
    }
    // The spans of the column's lines become boxes, which end where rows of the grid's cells do.
    void turn_into_boxes(std::uint32_t column) {
        const std::uint32_t side = round.plan.grid().side;
        const std::uint32_t strip = round.plan.strip_width;
        for (std::uint32_t line = begins[column]; line < begins[column + 1]; ++line)
            for (auto [begin, end] : lines_->spans_of(line))
                for (std::uint32_t to; begin < end; begin = to) {
                    to = begin + std::min(end - begin, side - begin % side);
                    boxes_[column].push_back({line * strip, strip, begin, to});
                }
    }

    std::uint32_t width_;         // of all bins
    std::optional<Lines> lines_;  // until the first refinement
};

}  // namespace

std::unique_ptr<Bins> make_uniform_boxes(const Plan& plan, Workers& workers) {
    return std::make_unique<UniformBoxes>(plan, workers);
}

}  // namespace lacuna::cpu
