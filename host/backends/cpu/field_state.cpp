// Memory and verbs of mode exact with a radius field.
#include "backends/cpu/field_state.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "backends/cpu/field_cut.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// How many boxes ahead their lists are prefetched.
constexpr std::size_t kFieldBoxesAhead = 8;

}  // namespace

FieldState::FieldState(const Plan& the_plan)
    : State(the_plan, the_plan.field().first_boxes->begins),
      radius_field(*the_plan.field().radius_field),
      first(*the_plan.field().first_boxes),
      boxes(columns),
      near(the_plan) {}

void FieldState::measure_boxes() {
    for (std::uint32_t region = 0; region < columns; ++region)
        bin_begins[region + 1] =
            bin_begins[region] + static_cast<std::uint32_t>(boxes[region].size());
    free_lengths.resize(bin_begins.back());
    bin_widths.resize(bin_begins.back());
    const Sheets& sheets = plan.field().sheets;
    for (std::uint32_t sheet = 0; sheet < sheet_ends.size(); ++sheet) {
        std::uint32_t region = 0;
        while (region < columns && sheets.of(first.nodes[first.regions[region]].box.x) <= sheet)
            ++region;
        sheet_ends[sheet] = bin_begins[region];
    }
}

void FieldState::measure_boxes(std::uint32_t region) {
    std::size_t i = bin_begins[region];
    for (const BlockBox& box : boxes[region]) {
        free_lengths[i] = box.at.end - box.at.begin;
        bin_widths[i++] = box.at.width;
    }
}

void FieldState::insert_admitted() {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const auto& [x, y, block, order] = candidates[i];
        if (statuses[i] == STATUS_ADMITTED)
            near.insert({x, y, radius_field.radius_at(x, y)}, block, nullptr);
    }
}

void set_free(FieldState& state, std::uint32_t region) {
    const FirstBoxes& first = state.first;
    first.for_each_box(first.nodes[first.regions[region]].first, first.begins[region + 1],
                       [&](std::uint32_t box, std::uint32_t block) {
                           state.boxes[region].push_back({first.boxes[box], block});
                       });
}

void locate(FieldState& state, std::span<const Draw> draws, std::uint32_t region) {
    for (std::uint32_t i = state.column_begins[region]; i < state.column_begins[region + 1]; ++i) {
        const auto& [at, block] = state.boxes[region][draws[i].bin - state.bin_begins[region]];
        state.candidates[i] = {at.x + draws[i].offset, at.begin + draws[i].rank, block,
                               draws[i].order};
        state.statuses[i] = STATUS_UNDECIDED;
    }
    state.find_orders(region);
    screen(state, region);
}

void refine(FieldState& state, std::uint32_t region, bool halve) {
    thread_local std::vector<FieldState::BlockBox> of_thread;
    std::vector<FieldState::BlockBox>& left = of_thread;  // looked up once, see subtract.cpp
    left.clear();
    SizedList scratch;
    FieldCut cut(state, region, left);
    const std::span<const FieldState::BlockBox> boxes = state.boxes[region];
    // Boxes that are not halved are cut only by samples that have not cut them yet.
    const auto which = halve ? NeighbourLists::Which::all : NeighbourLists::Which::latest;
    for (std::size_t i = 0, end; i < boxes.size(); i = end) {
        const std::uint32_t block = boxes[i].block;
        for (end = i + 1; end < boxes.size() && boxes[end].block == block;) ++end;
        const std::span<const FieldState::BlockBox> of_block = boxes.subspan(i, end - i);
        const std::uint32_t later = boxes[std::min(i + kFieldBoxesAhead, boxes.size() - 1)].block;
        if (halve || state.near.has_latest(later)) state.near.fetch_list(later);
        if (!halve && !state.near.has_latest(block)) {
            left.insert(left.end(), of_block.begin(), of_block.end());
            continue;
        }
        const std::size_t before = left.size();
        cut.begin(block);
        if (cut.can_append_all(halve) && !state.near.is_long(block)) {
            cut.cut_by(state.near.of_part(block, boxes[i].at, which, scratch));
            cut.append_all(of_block, halve);
        } else {
            for (const auto& [at, same] : of_block) {
                cut.cut_by(state.near.of_part(block, at, which, scratch));
                halve ? cut.append_halves(at) : cut.append(at);
                cut.finish();
            }
        }
        state.near.note_cuts(block);
        if (left.size() == before) state.near.close(block);
    }
    state.boxes[region].assign(left.begin(), left.end());
}

}  // namespace lacuna::cpu
