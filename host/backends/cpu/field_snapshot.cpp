// Snapshots of the cpu backend's memory with a radius field.
#include "backends/field_snapshot.h"

#include <algorithm>
#include <cstddef>

#include "backends/cpu/field_state.h"
#include "portable/status.h"

namespace lacuna::cpu {

// As with one radius, a snapshot has the round's samples among `samples` only after the round's
// last verb, and does not show what screen found.
Snapshot FieldState::snapshot(Stage stage) const {
    Snapshot snapshot;
    std::vector<Sample> of_round;
    for (const std::uint32_t i : by_order) {
        const Candidate& candidate = candidates[i];
        snapshot.candidates.push_back({candidate.x, candidate.y, 0, candidate.order});
        snapshot.statuses.push_back(stage == Stage::located ? STATUS_UNDECIDED : statuses[i]);
        if (stage == Stage::admitted && statuses[i] == STATUS_ADMITTED)
            of_round.push_back({candidate.x, candidate.y});
    }
    for (const std::vector<BlockBox>& of_region : boxes)
        for (const BlockBox& box : of_region) snapshot.boxes.push_back(box.at);
    snapshot.samples = near.samples();
    std::erase_if(snapshot.samples, [&](const Sample& sample) {
        return std::find(of_round.begin(), of_round.end(), sample) != of_round.end();
    });
    return snapshot;
}

std::uint32_t FieldState::region_of(std::uint32_t block) const {
    const auto after = std::upper_bound(
        first.regions.begin(), first.regions.end(), block,
        [&](std::uint32_t at, std::uint32_t node) { return at < first.nodes[node].first; });
    return static_cast<std::uint32_t>(after - first.regions.begin()) - 1;
}

void FieldState::restore(const Snapshot& snapshot) {
    near.put(with_radii(plan, snapshot.samples));
    for (std::uint32_t block = 0; block < first.block_count(); ++block) near.note_cuts(block);
    boxes.assign(columns, {});
    for (const Box& box : snapshot.boxes) {
        const std::uint32_t block = block_at(first, box.x, box.begin);
        boxes[region_of(block)].push_back({box, block});
    }
    measure_boxes();
    for (std::uint32_t region = 0; region < columns; ++region) measure_boxes(region);

    // The candidates, region by region.
    const std::size_t count = snapshot.candidates.size();
    make_room(count);
    by_order.resize(count);
    std::vector<std::vector<std::uint32_t>> of_region(columns);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Candidate& candidate = snapshot.candidates[i];
        of_region[region_of(block_at(first, candidate.x, candidate.y))].push_back(i);
    }
    std::uint32_t next = 0;
    for (std::uint32_t region = 0; region < columns; ++region) {
        for (const std::uint32_t i : of_region[region]) {
            const auto& [x, y, line, order] = snapshot.candidates[i];
            candidates[next] = {x, y, block_at(first, x, y), order};
            statuses[next] = snapshot.statuses[i];
            by_order[order] = next++;
        }
        column_begins[region + 1] = next;
    }
}

}  // namespace lacuna::cpu
