// Neighbour lists on a device: of samples, and of candidates that may become samples.
#include "backends/device/neighbour_lists.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "backends/device/layout.h"
#include "plan/radius_field.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

// See Queue::launch.
constexpr std::uint64_t kReachWork = 4;
constexpr std::uint64_t kEnlistWork = 1;

// Blocks that a draw reaches, at first; most draws are soon covered. If the room is too small, the
// blocks are listed again.
constexpr std::uint64_t kVisitsPerDraw = 8;

// With classes a sample may reach most blocks. The samples of the first part close most of these
// before later parts, each as large as all before it, would be listed for them.
constexpr std::uint32_t kFirstPart = 64;

}  // namespace

NeighbourLists::NeighbourLists(RoundMemory& round)
    : round_(round),
      first_(*round.plan.field().first_boxes),
      visits_all_at_once_(!may_visit_many()) {
    make_tree();
    Memory& m = round_.memory;
    round_.make_room(m.lists, blocks());
    round_.make_room(m.entries, 4 * room_for_entries(round_.plan));
    round_.make_room(m.visitor_heads, blocks());
    round_.make_room(m.survivors, 1);
}

// Whether the nodes that a candidate reaches, at most, are more than may be visited
// at once. Within a class they are few.
bool NeighbourLists::may_visit_many() const {
    const ClassCopies& copies = round_.plan.field().copies;
    if (!copies.are_several()) return false;
    double visits = 0;
    for (const std::uint32_t root : first_.copies) {
        const auto& [box, greatest, next, first, whole] = first_.nodes[root];
        const double reach =
            portable::times_factor(greatest, copies.greatest_factor(copies.of(box.x)));
        const double nodes = next - root;
        // As many nodes lie beside the reach as would fit between two rows of blocks.
        const auto share = [&](double length) {
            return std::min(1.0, 2 * reach / length + 4 / std::sqrt(nodes));
        };
        visits += nodes * share(box.width) * share(box.end - box.begin);
    }
    return visits > NODES_AT_ONCE;
}

void NeighbourLists::make_tree() {
    Memory& m = round_.memory;
    std::vector<Box> boxes;
    std::vector<std::uint32_t> links;
    for (const FirstBoxes::Node& node : first_.nodes) {
        boxes.push_back(node.box);
        links.insert(links.end(), {node.greatest, node.next, node.first, node.whole});
    }
    round_.make_room(m.tree_boxes, 4 * boxes.size());
    round_.put<Box>(m.tree_boxes, boxes);
    m.tree_links = round_.copy_of(links);
    std::vector<std::uint32_t> node_of;  // of each block, and the least radius under it
    for (std::uint32_t i = 0; i < blocks(); ++i)
        node_of.insert(node_of.end(), {first_.blocks[i].node, first_.blocks[i].least});
    m.node_of = round_.copy_of(node_of);
    round_.make_room(m.open_parts, first_.nodes.size());
    round_.queue.wait();
}

void NeighbourLists::put(std::span<const Sized> samples) {
    Memory& m = round_.memory;
    round_.queue.fill(m.lists, NO_SAMPLE, blocks());
    round_.queue.fill(m.report, 0, REPORT_WORDS);
    round_.report = {};
    entries_before_ = 0;
    const std::vector<std::uint32_t> open_parts = first_.part_counts();
    round_.put<std::uint32_t>(m.open_parts, open_parts);
    first_recent_ = 0;
    const auto count = static_cast<std::uint32_t>(samples.size());
    // Without a block the tree is empty, and kernels that descend into it would read other memory.
    if (count == 0 || blocks() == 0) return round_.queue.wait();
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> radii;
    for (std::uint32_t i = 0; i < count; ++i) {
        candidates.push_back({samples[i].x, samples[i].y, NO_SAMPLE, i});
        radii.push_back(samples[i].radius);
    }
    const std::vector<std::uint32_t> statuses(count, STATUS_ADMITTED);
    round_.put_in_room<Candidate>(m.candidates, candidates);
    round_.put_in_room<std::uint32_t>(m.candidate_radii, radii);
    round_.put_in_room<std::uint32_t>(m.statuses, statuses);
    const std::uint32_t first_part = round_.plan.field().copies.are_several() ? kFirstPart : count;
    for (std::uint32_t begin = 0; begin < count; begin = round_.part.end) {
        round_.part = {begin, std::min(count, std::max(first_part, 2 * begin))};
        begin_part();
        enlist();
        round_.start_download();
        round_.queue.wait();
        round_.throw_if_failed();
    }
    entries_before_ = std::exchange(round_.report[ENTRIES_WORD], 0u);
}

std::vector<Sample> NeighbourLists::get() const {
    std::vector<Candidate> list(entries());  // as wide as an entry
    round_.get<Candidate>(round_.memory.entries, list);
    round_.queue.wait();
    std::vector<Sample> samples;
    samples.reserve(list.size());
    for (const Candidate& entry : list) samples.push_back({entry.x, entry.y});
    return samples;
}

void NeighbourLists::begin_survivors() {
    round_.make_room(round_.memory.survivors, round_.draw_count);
    listed_ = Listed::survivors;
}

void NeighbourLists::list_visitors() {
    if (listed_ == Listed::visitors) return;
    Memory& m = round_.memory;
    std::uint64_t room = kVisitsPerDraw * round_.part_count();
    do {
        room = std::max<std::uint64_t>(room, round_.report[VISITORS_WORD]);
        round_.reset(VISITORS_WORD);
        round_.make_room(m.visitors, 2 * room);
        round_.queue.fill(m.visitor_heads, NO_SAMPLE, blocks());
        portable::DrawArguments arguments = round_.arguments();
        arguments.room = static_cast<std::uint32_t>(room);
        arguments.is_listed = listed_ == Listed::survivors ? 1 : 0;
        const std::uint64_t nodes = visits_all_at_once_ ? 1 : first_.nodes.size();
        for (std::uint64_t node = 0; node < nodes; node += NODES_AT_ONCE) {
            arguments.first_node =
                visits_all_at_once_ ? ALL_NODES : static_cast<std::uint32_t>(node);
            round_.launch_over_draws<kernels::reach>(arguments, kReachWork);
        }
        round_.start_download();
        round_.queue.wait();
    } while (round_.report[VISITORS_WORD] > room);
    round_.grow(m.entries, 4 * std::uint64_t{entries()},
                4 * (std::uint64_t{entries()} + round_.report[VISITORS_WORD]));
    listed_ = Listed::visitors;
}

void NeighbourLists::end_round() {
    first_recent_ = entries_before_ = entries();
    round_.report[ENTRIES_WORD] = 0;
}

void NeighbourLists::enlist() {
    list_visitors();
    portable::DrawArguments arguments = round_.arguments();
    arguments.count = blocks();
    arguments.chunk = round_.queue.chunk_of(arguments.count);
    arguments.room = entries_before_;
    launch<kernels::enlist>(round_.queue, round_.memory, arguments,
                            items_of(arguments.count, arguments.chunk),
                            kEnlistWork * arguments.chunk);
}

}  // namespace lacuna::device
