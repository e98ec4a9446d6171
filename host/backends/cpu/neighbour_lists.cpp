// Neighbour lists: the way along the tree of blocks, and the splitting of long lists.
#include "backends/cpu/neighbour_lists.h"

#include <algorithm>
#include <array>
#include <utility>

#include "backends/field_snapshot.h"
#include "plan/radius_field.h"
#include "portable/distance.h"

namespace lacuna::cpu {
namespace {

// Whether the sample is closer to the box than both its own radius and the greatest under the box.
bool is_reached(const Box& box, std::uint32_t greatest, const Sized& sample, std::uint32_t period_x,
                std::uint32_t period_y) {
    const std::uint64_t reach = std::min(sample.radius, greatest);
    return portable::squared_length(
               portable::distance_to_stretch(sample.x, box.x, box.x + box.width, period_x),
               portable::distance_to_stretch(sample.y, box.begin, box.end, period_y)) <
           reach * reach;
}

// The same without wrapping, and without a branch.
bool is_reached(const Box& box, std::uint32_t greatest, const Sized& sample) {
    const auto distance = [](std::uint32_t at, std::uint32_t begin, std::uint32_t last) {
        return std::max(at, last) - last + (begin - std::min(at, begin));
    };
    const std::uint64_t reach = std::min(sample.radius, greatest);
    return portable::squared_length(distance(sample.x, box.x, box.x + box.width - 1),
                                    distance(sample.y, box.begin, box.end - 1)) < reach * reach;
}

}  // namespace

NeighbourLists::NeighbourLists(const Plan& plan)
    : plan_(plan),
      first_(*plan.field().first_boxes),
      vectors_(*all_vectors().front()),
      few_(0),
      long_(first_.block_count()),
      marked_(first_.regions.size()) {
    put(plan.field().kept);
}

void NeighbourLists::put(std::span<const Sized> samples) {
    few_ = ZeroedArray<Few>(first_.block_count() + std::size_t{1});  // vector loads read past it
    states_.assign(first_.block_count(), 0);
    for (const Sized& sample : samples)
        for_each_reached(sample, 0, [&](std::uint32_t block) { push(sample, block); });
}

bool NeighbourLists::sticks_out(const Sized& sample) const {
    const Box& all = first_.nodes.front().box;
    return plan_.period_x != 0 &&
           (sample.x - all.x < sample.radius || all.x + all.width - sample.x <= sample.radius ||
            sample.y - all.begin < sample.radius || all.end - sample.y <= sample.radius);
}

bool NeighbourLists::is_within(const Sized& sample, std::uint32_t node) const {
    const Box& all = first_.nodes.front().box;
    const Box& box = first_.nodes[node].box;
    const auto is_along = [&](std::uint32_t at, std::uint32_t begin, std::uint32_t end,
                              std::uint32_t all_begin, std::uint32_t all_end) {
        return (at - begin >= sample.radius || begin == all_begin) &&
               (end - at > sample.radius || end == all_end);
    };
    return is_along(sample.x, box.x, box.x + box.width, all.x, all.x + all.width) &&
           is_along(sample.y, box.begin, box.end, all.begin, all.end);
}

template <typename Visit>
void NeighbourLists::for_each_reached(const Sized& sample, std::uint32_t root, Visit visit) const {
    const std::uint32_t end = first_.nodes[root].next;
    const bool wraps = root == 0 && plan_.period_x != 0;
    for (std::uint32_t i = root; i < end;) {
        const FirstBoxes::Node& node = first_.nodes[i];
        if (wraps ? !is_reached(node.box, node.greatest, sample, plan_.period_x, plan_.period_y)
                  : !is_reached(node.box, node.greatest, sample)) {
            i = node.next;
            continue;
        }
        ++i;
        if (i == node.next) visit(node.first);
    }
}

// Climbs the tree from the block, and descends into the siblings that it passes. All lists to be
// written are prefetched before the first one is written.
void NeighbourLists::insert(const Sized& sample, std::uint32_t block) {
    std::array<std::uint32_t, 32> reached;
    std::size_t count = 0;
    const auto push_all = [&] {
        for (std::size_t i = 0; i < count; ++i) push(sample, reached[i]);
        count = 0;
    };
    const auto note = [&](std::uint32_t near) {
        if ((states_[near] & kClosed) != 0) return;
        fetch_list(near);
        reached[count++] = near;
        if (count == reached.size()) push_all();
    };
    if (sticks_out(sample)) {
        for_each_reached(sample, 0, note);
        return push_all();
    }
    note(block);
    for (std::uint32_t node = first_.blocks[block].node; node != 0 && !is_within(sample, node);) {
        const std::uint32_t part = node;
        node = first_.nodes[node].whole;
        for (std::uint32_t i = node + 1; i < first_.nodes[node].next; i = first_.nodes[i].next)
            if (i != part) for_each_reached(sample, i, note);
    }
    push_all();
}

void NeighbourLists::push(const Sized& sample, std::uint32_t block) {
    states_[block] |= kLatest;
    Few& few = few_[block];
    if (few.count == kFew) return push_long(sample, block);
    few.x[few.count] = sample.x;
    few.y[few.count] = sample.y;
    few.radius[few.count++] = sample.radius;
}

void NeighbourLists::push_long(const Sized& sample, std::uint32_t block) {
    Few& few = few_[block];
    std::unique_ptr<List>& list = long_[block];
    if (!few.is_long) {
        list = std::make_unique<List>();
        list->near.append(few.span());
        list->cuts = few.cuts;
        few.is_long = true;
    }
    add(*list, box_of(block), sample);
}

void NeighbourLists::note_cuts(std::uint32_t block) {
    states_[block] &= static_cast<std::uint8_t>(~kLatest);
    Few& few = few_[block];
    few.cuts = few.count;
    if (few.is_long) note_cuts(*long_[block]);
}

void NeighbourLists::note_cuts(List& list) {
    list.cuts = list.near.size();
    if (list.split)
        for (Half* const half : {&list.split->low, &list.split->high}) note_cuts(half->list);
}

SizedSpan NeighbourLists::long_part(std::uint32_t block, Sample at) const {
    const List* list = long_[block].get();
    while (list->split) list = &list->split->part_at(at);
    return list->near.span();
}

bool NeighbourLists::reaches(const Sized& sample, const Box& box, std::uint32_t greatest) const {
    return is_reached(box, greatest, sample, plan_.period_x, plan_.period_y);
}

void NeighbourLists::add(List& list, const Box& box, const Sized& sample) {
    if (!list.split) {
        list.near.push_back(sample);
        if (list.near.size() > list.most) split(list, box);
        return;
    }
    for (Half* const half : {&list.split->low, &list.split->high})
        if (reaches(sample, half->box, half->greatest)) add(half->list, half->box, sample);
}

// Does nothing if one half would keep more than three quarters of the list.
void NeighbourLists::split(List& list, const Box& box) {
    const std::uint32_t height = box.end - box.begin;
    const std::uint32_t x = box.x + box.width / 2;
    const std::uint32_t y = box.begin + height / 2;
    list.most *= 2;
    if (std::max(box.width, height) < 2) return;
    auto parts = std::make_unique<Split>();
    if (box.width >= height) {
        parts->low.box = {box.x, x - box.x, box.begin, box.end};
        parts->high.box = {x, box.x + box.width - x, box.begin, box.end};
    } else {
        parts->low.box = {box.x, box.width, box.begin, y};
        parts->high.box = {box.x, box.width, y, box.end};
    }
    for (Half* const half : {&parts->low, &parts->high}) {
        half->greatest = plan_.field().radius_field->under(half->box).greatest;
        for (std::size_t i = 0; i < list.near.size(); ++i)
            if (reaches(list.near.span()[i], half->box, half->greatest)) {
                half->list.near.push_back(list.near.span()[i]);
                if (i < list.cuts) ++half->list.cuts;
            }
        half->list.most = std::max(half->list.most, 2 * half->list.near.size());
    }
    if (4 * std::max(parts->low.list.near.size(), parts->high.list.near.size()) >
        3 * list.near.size())
        return;
    list.near = {};
    list.split = std::move(parts);
}

void NeighbourLists::gather(const List& list, const Box& part, Which which, SizedList& found) {
    if (!list.split) {
        found.append(list.near.span().from(which == Which::latest ? list.cuts : 0));
        return;
    }
    const Box& high = list.split->high.box;
    if (part.x < high.x || part.begin < high.begin)
        gather(list.split->low.list, part, which, found);
    if (part.x + part.width > high.x && part.end > high.begin)
        gather(list.split->high.list, part, which, found);
}

SizedSpan NeighbourLists::of_long_part(std::uint32_t block, const Box& part, Which which,
                                       SizedList& scratch) const {
    scratch.clear();
    gather(*long_[block], part, which, scratch);
    return scratch.span();
}

void NeighbourLists::mark(const Sized& candidate, std::uint32_t region) {
    for_each_reached(candidate, first_.regions[region], [&](std::uint32_t near) {
        if (is_marked(near)) return;
        states_[near] |= kMarked;
        marked_[region].push_back(near);
    });
}

void NeighbourLists::unmark_all() {
    for (std::vector<std::uint32_t>& of_region : marked_) {
        for (const std::uint32_t block : of_region)
            states_[block] &= static_cast<std::uint8_t>(~kMarked);
        of_region.clear();
    }
}

std::vector<Sample> NeighbourLists::samples() const {
    std::vector<Sample> all;
    SizedList found;
    for (std::uint32_t block = 0; block < first_.block_count(); ++block) {
        const SizedSpan near = of_part(block, box_of(block), Which::all, found);
        for (std::size_t i = 0; i < near.count; ++i) all.push_back({near.x[i], near.y[i]});
    }
    sort_for_snapshot(all);
    return all;
}

}  // namespace lacuna::cpu
