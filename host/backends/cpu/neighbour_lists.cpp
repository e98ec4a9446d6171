// Neighbour lists: the way along the tree of blocks, and the splitting of long lists.
#include "backends/cpu/neighbour_lists.h"

#include <algorithm>
#include <array>
#include <utility>

#include "backends/field_snapshot.h"
#include "base/polling.h"
#include "plan/radius_field.h"
#include "portable/distance.h"

namespace lacuna::cpu {
namespace {

// Whether the sample is closer to the box than both its own radius and the greatest under the box,
// each times the factor. Without periods there is no branch.
bool is_reached(const Box& box, std::uint32_t greatest, const Sized& sample, std::uint64_t factor,
                std::uint32_t period_x, std::uint32_t period_y) {
    const auto distance = [](std::uint32_t at, std::uint32_t begin, std::uint32_t end,
                             std::uint32_t period) {
        if (period != 0) return portable::distance_to_stretch(at, begin, end, period);
        return std::max(at, end - 1) - (end - 1) + (begin - std::min(at, begin));
    };
    return portable::squared_length(distance(sample.x, box.x, box.x + box.width, period_x),
                                    distance(sample.y, box.begin, box.end, period_y)) <
           portable::squared_limit(sample.radius, greatest, factor);
}

// Between two polls 2048 samples are listed.
constexpr std::size_t kWorkOfSample = kBetweenPolls / 2048;

bool lies_in(const Box& box, const Sized& sample) {
    return sample.x - box.x < box.width && sample.y >= box.begin && sample.y < box.end;
}

}  // namespace

NeighbourLists::NeighbourLists(const Plan& plan)
    : plan_(plan),
      first_(*plan.field().first_boxes),
      copies_(plan.field().copies),
      radius_field_(*plan.field().radius_field),
      vectors_(*all_vectors().front()),
      few_(0),
      long_(first_.block_count()),
      marked_(first_.zones.size()) {
    put(plan.field().kept);
}

void NeighbourLists::put(std::span<const Sized> samples) {
    few_ = ZeroedArray<Few>(first_.block_count() + std::size_t{1});  // vector loads read past it
    states_.assign(first_.block_count(), 0);
    if (copies_.are_several()) {
        closed_.begin(first_);
        all_marked_.begin(first_);
    }
    for (const Sized& sample : samples) {
        ask_after(kWorkOfSample);
        for (const std::uint32_t root : first_.copies) {
            const There here = there(sample, copies_.of(first_.nodes[root].box.x));
            for_each_reached(here, root, plan_.period_x != 0, closed_,
                             [&](std::uint32_t block) { push(here, sample, block); });
        }
    }
}

void NeighbourLists::close(std::uint32_t block) {
    if (is_closed(block)) return;
    states_[block] |= kClosed;
    if (closed_.has_begun()) closed_.finish(block);
}

bool NeighbourLists::covers(const There& there, std::uint32_t block) const {
    const auto& [x, width, begin, end] = box_of(block);
    return portable::covers_box(there.sample, x, width, begin, end, first_.blocks[block].least,
                                there.factor, plan_.period_x, plan_.period_y);
}

NeighbourLists::There NeighbourLists::there(const Sized& sample, std::uint32_t copy) const {
    const std::uint64_t factor = copies_.factor(copies_.of(sample.x), copy);
    return {{copies_.x_on(copy, sample.x), sample.y, sample.radius},
            factor,
            portable::times_factor(sample.radius, factor),
            radius_field_.has_ellipses() ? &radius_field_.ellipse_at(sample.x, sample.y) : nullptr,
            copies_.of(sample.x) == copy};
}

bool NeighbourLists::misses(const There& there, const Box& box, bool wraps) const {
    return portable::ellipse_misses(there.sample, *there.ellipse, box.x, box.width, box.begin,
                                    box.end, wraps ? plan_.period_x : 0,
                                    wraps ? plan_.period_y : 0);
}

bool NeighbourLists::sticks_out(const There& there, std::uint32_t root) const {
    const Box& all = first_.nodes[root].box;
    const auto& [sample, factor, reach, ellipse, is_own] = there;
    return plan_.period_x != 0 &&
           (sample.x - all.x < reach || all.x + all.width - sample.x <= reach ||
            sample.y - all.begin < reach || all.end - sample.y <= reach);
}

bool NeighbourLists::is_within(const There& there, std::uint32_t node, std::uint32_t root) const {
    const Box& all = first_.nodes[root].box;
    const Box& box = first_.nodes[node].box;
    const Sized& sample = there.sample;
    const std::uint32_t reach = there.reach;
    const auto is_along = [&](std::uint32_t at, std::uint32_t begin, std::uint32_t end,
                              std::uint32_t all_begin, std::uint32_t all_end) {
        return (at - begin >= reach || begin == all_begin) && (end - at > reach || end == all_end);
    };
    return is_along(sample.x, box.x, box.x + box.width, all.x, all.x + all.width) &&
           is_along(sample.y, box.begin, box.end, all.begin, all.end);
}

template <typename Visit>
void NeighbourLists::for_each_reached(const There& there, std::uint32_t root, bool wraps,
                                      const DoneNodes& done, Visit visit) const {
    const std::uint32_t end = first_.nodes[root].next;
    const auto& [sample, factor, reach, ellipse, is_own] = there;
    for (std::uint32_t i = root; i < end;) {
        const FirstBoxes::Node& node = first_.nodes[i];
        if (done.is_done(i) && !(is_own && lies_in(node.box, sample))) {
            i = node.next;
            continue;
        }
        const bool is_near = wraps ? is_reached(node.box, node.greatest, sample, factor,
                                                plan_.period_x, plan_.period_y)
                                   : is_reached(node.box, node.greatest, sample, factor, 0, 0);
        if (!is_near || (ellipse != nullptr && misses(there, node.box, wraps))) {
            i = node.next;
            continue;
        }
        ++i;
        if (i == node.next) visit(node.first);
    }
}

// On the sample's own copy, climbs the tree from the block, and descends into the siblings that it
// passes. All lists to be written are prefetched before the first one is written.
void NeighbourLists::insert(const Sized& sample, std::uint32_t block,
                            const FirstBoxes::Zone* within) {
    std::array<std::uint32_t, 32> reached;
    std::size_t count = 0;
    There here{};
    const auto push_all = [&] {
        for (std::size_t i = 0; i < count; ++i) push(here, sample, reached[i]);
        count = 0;
    };
    const auto note = [&](std::uint32_t near) {
        if (is_closed(near) && near != block) return;
        fetch_list(near);
        reached[count++] = near;
        if (count == reached.size()) push_all();
    };
    for (std::size_t k = 0; k < first_.copies.size(); ++k) {
        push_all();
        const std::uint32_t root = first_.copies[k];
        const std::uint32_t copy = copies_.of(first_.nodes[root].box.x);
        here = there(sample, copy);
        const bool wraps = sticks_out(here, root);
        if (wraps || copies_.of(sample.x) != copy) {
            for_each_reached(here, within == nullptr ? root : within->nodes[k], wraps, closed_,
                             note);
            continue;
        }
        note(block);
        std::uint32_t node = first_.blocks[block].node;
        while (node != root && !is_within(here, node, root)) {
            const std::uint32_t part = node;
            node = first_.nodes[node].whole;
            for (std::uint32_t i = node + 1; i < first_.nodes[node].next; i = first_.nodes[i].next)
                if (i != part) for_each_reached(here, i, false, closed_, note);
        }
    }
    push_all();
}

bool NeighbourLists::is_any_seen_closer(const SizedSpan& near, Sample at,
                                        std::uint32_t radius) const {
    thread_local SizedList of_thread;
    SizedList& seen = of_thread;  // looked up once, see subtract.cpp
    seen.see(copies_, copies_.of(at.x), near, radius);
    return vectors_.is_any_sized_closer(seen.span(), at, kAnyRadius,
                                        {plan_.period_x, plan_.period_y});
}

// Floats tell for several samples at once that they do not lie in the candidate's ellipse.
bool NeighbourLists::is_any_ellipse_closer(const SizedSpan& near, Sample at,
                                           std::uint32_t radius) const {
    const Sized candidate{at.x, at.y, radius};
    const portable::Ellipse& own = radius_field_.ellipse_at(at.x, at.y);
    const bool wraps =
        sticks_out({candidate, FACTOR_ONE, radius, &own, true}, first_.copies.front());
    const FloatEllipse in_floats = cpu::in_floats(own);
    const auto next = [&](std::size_t from) {
        return wraps ? from : vectors_.next_in_ellipse(near, at, in_floats, from);
    };
    for (std::size_t i = next(0); i < near.count; i = next(i + 1))
        if (portable::ellipses_conflict(candidate, own, near[i],
                                        radius_field_.ellipse_at(near.x[i], near.y[i]),
                                        plan_.period_x, plan_.period_y))
            return true;
    return false;
}

void NeighbourLists::push(const There& there, const Sized& sample, std::uint32_t block) {
    push(sample, block);
    if (copies_.are_several() && covers(there, block)) close(block);
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
    const There here = there(sample, copies_.of(box.x));
    return is_reached(box, greatest, here.sample, here.factor, plan_.period_x, plan_.period_y);
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
    const List& list = *long_[block];
    if (!list.split) return list.near.span().from(which == Which::latest ? list.cuts : 0);
    scratch.clear();
    gather(list, part, which, scratch);
    return scratch.span();
}

void NeighbourLists::mark(const Sized& candidate, std::uint32_t zone) {
    const auto note = [&](std::uint32_t near) {
        if (is_marked(near)) return;
        states_[near] |= kMarked;
        marked_[zone].push_back(near);
        if (all_marked_.has_begun()) all_marked_.finish(near);
    };
    for (const std::uint32_t node : first_.zones[zone].nodes)
        for_each_reached(there(candidate, copies_.of(first_.nodes[node].box.x)), node,
                         first_.nodes[node].whole == 0 && plan_.period_x != 0, all_marked_, note);
}

void NeighbourLists::unmark_all(std::span<const Candidate>, std::span<const std::uint32_t>) {
    for (std::vector<std::uint32_t>& of_zone : marked_) {
        for (const std::uint32_t block : of_zone) {
            states_[block] &= static_cast<std::uint8_t>(~kMarked);
            if (all_marked_.has_begun()) all_marked_.undo(block);
        }
        of_zone.clear();
    }
}

std::uint32_t NeighbourLists::line_at(std::uint32_t x, std::uint32_t y) const {
    return block_at(first_, x, y);
}

std::uint32_t NeighbourLists::column_of(std::uint32_t block) const {
    const auto after = std::upper_bound(
        first_.regions.begin(), first_.regions.end(), block,
        [&](std::uint32_t at, std::uint32_t node) { return at < first_.nodes[node].first; });
    return static_cast<std::uint32_t>(after - first_.regions.begin()) - 1;
}

void NeighbourLists::snapshot(Snapshot& snapshot, std::span<const Sample> left_out) const {
    SizedList found;
    for (std::uint32_t block = 0; block < first_.block_count(); ++block) {
        const SizedSpan near = of_part(block, box_of(block), Which::all, found);
        for (std::size_t i = 0; i < near.count; ++i)
            snapshot.samples.push_back({near.x[i], near.y[i]});
    }
    sort_for_snapshot(snapshot.samples);
    std::erase_if(snapshot.samples, [&](const Sample& sample) {
        return std::find(left_out.begin(), left_out.end(), sample) != left_out.end();
    });
}

void NeighbourLists::restore(const Snapshot& snapshot) {
    put(with_radii(plan_, snapshot.samples));
    for (std::uint32_t block = 0; block < first_.block_count(); ++block) note_cuts(block);
}

}  // namespace lacuna::cpu
