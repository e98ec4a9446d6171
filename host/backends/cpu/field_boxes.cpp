// The bins of mode exact with a radius field: active boxes from the first round on.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/cpu/boxes.h"
#include "backends/cpu/list_rules.h"
#include "plan/first_free.h"
#include "plan/radius_field.h"

namespace lacuna::cpu {
namespace {

class FieldBoxes : public Boxes<NeighbourLists> {
public:
    FieldBoxes(const Plan& plan, Workers& workers)
        : Boxes(plan, workers, static_cast<std::uint32_t>(first_of(plan).regions.size())) {
        FirstFree first(plan);
        begins = first_of(plan).begins;
        free_lengths = std::move(first.lengths);
        widths_ = std::move(first.widths);
        copy_ends_ = std::move(first.copy_ends);
    }

    void set_free() override {
        const FirstBoxes& first = first_of(round.plan);
        for_columns(begins.back(), [&](std::uint32_t region) {
            first.for_each_box(first.nodes[first.regions[region]].first, begins[region + 1],
                               [&](std::uint32_t box, std::uint32_t block) {
                                   boxes_[region].push_back({first.boxes[box], block});
                               });
        });
    }
    void subtract() override { throw std::logic_error("a radius field is refined from the start"); }

    std::span<const std::uint32_t> widths() const override { return widths_; }
    std::span<const std::uint32_t> copy_ends() const override { return copy_ends_; }

    // The candidates are in the order of their draws, and do not have their blocks.
    Snapshot snapshot(std::span<const Sample> left_out) const override {
        Snapshot snapshot = Boxes::snapshot(left_out);
        for (std::uint32_t order = 0; order < round.by_order.size(); ++order) {
            const std::uint32_t i = round.by_order[order];
            snapshot.candidates[order] = {round.candidates[i].x, round.candidates[i].y, 0, order};
            snapshot.statuses[order] = round.statuses[i];
        }
        return snapshot;
    }

private:
    static const FirstBoxes& first_of(const Plan& plan) { return *plan.field().first_boxes; }

    void settle() override {
        Boxes::settle();
        widths_.resize(begins.back());
        for_columns(begins.back(), [&](std::uint32_t region) {
            std::size_t bin = begins[region];
            for (const BlockBox& box : boxes_[region]) widths_[bin++] = box.at.width;
        });
        const FirstBoxes& first = first_of(round.plan);
        const ClassCopies& copies = round.plan.field().copies;
        for (std::uint32_t copy = 0; copy < copy_ends_.size(); ++copy) {
            std::uint32_t region = 0;
            while (region < round.columns &&
                   copies.of(first.nodes[first.regions[region]].box.x) <= copy)
                ++region;
            copy_ends_[copy] = begins[region];
        }
    }

    std::vector<std::uint32_t> widths_;  // of each bin
    std::vector<std::uint32_t> copy_ends_;
};

template <typename Rule>
class FieldBoxesBy : public FieldBoxes {
public:
    using FieldBoxes::FieldBoxes;

private:
    void refine_column(std::uint32_t column, bool halve) override {
        refine_by<Rule>(column, halve);
    }
};

}  // namespace

std::unique_ptr<Bins> make_field_boxes(const Plan& plan, Workers& workers) {
    if (plan.field().copies.are_several())
        return std::make_unique<FieldBoxesBy<Classes>>(plan, workers);
    if (plan.field().radius_field->has_ellipses())
        return std::make_unique<FieldBoxesBy<Ellipses>>(plan, workers);
    return std::make_unique<FieldBoxesBy<Radii>>(plan, workers);
}

}  // namespace lacuna::cpu
