// Mode exact's active boxes on the cpu, with either neighbour index: the sample grid or, with a
// radius field, the neighbour lists.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "backends/cpu/bins.h"
#include "backends/cpu/box_cutter.h"
#include "backends/cpu/darts.h"

namespace lacuna::cpu {

template <typename Index>
class Boxes : public Bins {
public:
    using Active = typename Index::Active;  // a box with what its neighbours are found by

    Boxes(const Plan& plan, Workers& workers, std::uint32_t columns)
        : Bins(plan, workers, columns), index_(plan), boxes_(columns) {}

    void locate(std::span<const Draw> draws) override {
        for_columns(draws.size(), [&](std::uint32_t column) {
            const std::uint32_t end = round.column_begins[column + 1];
            for (std::uint32_t i = round.column_begins[column]; i < end; ++i) {
                const Draw& draw = draws[i];
                const Active& active = boxes_[column][draw.bin - begins[column]];
                const Box& box = Index::box_of(active);
                round.candidates[i] = {box.x + draw.offset, box.begin + draw.rank,
                                       index_.line_of(active), draw.order};
            }
            end_locate(column);
        });
    }
    void screen() override {
        for_columns(round.count(), [&](std::uint32_t column) { screen_column(column); });
    }
    bool admit() override {
        darts_.throw_all(index_, round, workers_);
        return false;
    }
    void insert() override {
        for (std::uint32_t i = 0; i < round.count(); ++i)
            if (round.statuses[i] == STATUS_ADMITTED) index_.insert(round.candidates[i]);
    }
    void refine(bool halve) override {
        for_columns(begins.back(), [&](std::uint32_t column) { refine_column(column, halve); });
        settle();
    }

    Snapshot snapshot(std::span<const Sample> left_out) const override {
        Snapshot snapshot = round.snapshot();
        for (const std::vector<Active>& of_column : boxes_)
            for (const Active& active : of_column) snapshot.boxes.push_back(Index::box_of(active));
        index_.snapshot(snapshot, left_out);
        return snapshot;
    }
    void restore(const Snapshot& snapshot) override {
        index_.restore(snapshot);
        round.restore(snapshot, [&](Candidate& candidate) {
            candidate.home = index_.line_at(candidate.x, candidate.y);
            return index_.column_of(candidate.home);
        });
        boxes_.assign(round.columns, {});
        for (const Box& box : snapshot.boxes) {
            const std::uint32_t line = index_.line_at(box.x, box.begin);
            boxes_[index_.column_of(line)].push_back(Index::active(box, line));
        }
        settle();
    }

protected:
    // Called after the column's draws became candidates.
    void end_locate(std::uint32_t column) {
        round.set_undecided(column);
        round.find_orders(column);
        screen_column(column);
    }
    void screen_column(std::uint32_t column) { cpu::screen(index_, round, column); }

    // Replaces the column's boxes by the pieces that the samples near them leave, with refine_by
    // the plan's rule (box_cutter.h).
    virtual void refine_column(std::uint32_t column, bool halve) = 0;
    template <typename Rule>
    void refine_by(std::uint32_t column, bool halve) {
        thread_local typename BoxCutter<Rule>::Scratch of_thread;
        auto& scratch = of_thread;  // looked up once, see subtract.cpp
        Rule rule(index_, halve);
        BoxCutter<Rule>(rule, scratch).refine(boxes_[column]);
        boxes_[column] = std::vector<Active>(scratch.left.begin(), scratch.left.end());
    }
    // Makes the boxes the bins.
    virtual void settle() {
        for (std::uint32_t column = 0; column < round.columns; ++column)
            begins[column + 1] = begins[column] + static_cast<std::uint32_t>(boxes_[column].size());
        free_lengths.resize(begins.back());
        for_columns(begins.back(), [&](std::uint32_t column) {
            std::size_t bin = begins[column];
            for (const Active& active : boxes_[column]) {
                const Box& box = Index::box_of(active);
                free_lengths[bin++] = box.end - box.begin;
            }
        });
    }

    Index index_;
    std::vector<std::vector<Active>> boxes_;  // of each column
    Darts darts_;
};

}  // namespace lacuna::cpu
