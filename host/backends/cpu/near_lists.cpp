// Down the tree of first places.
#include "backends/cpu/near_lists.h"

#include <algorithm>

#include "plan/ground.h"

namespace lacuna::cpu {
namespace {

// How far a place is from [begin, end) on one axis, which wraps after `period` units, or not.
std::uint32_t distance_to(std::uint32_t at, std::uint32_t begin, std::uint32_t end,
                          std::uint32_t period) {
    const std::uint32_t straight = portable::nearest_distance(at, begin, end);
    if (straight == 0 || period == 0) return straight;
    return std::min(portable::axis_distance(at, begin, period),
                    portable::axis_distance(at, end - 1, period));
}

}  // namespace

NearLists::NearLists(const Plan& plan)
    : plan_(plan), first_(*plan.first_places), lists_(first_.places.size()) {
    for (const Sample sample : plan.kept)
        insert_below({sample.x, sample.y, plan.ground->radius_at(sample.x, sample.y)}, 0);
}

std::uint32_t NearLists::node_around(const Sized& sample, std::uint32_t first_place) const {
    std::uint32_t node = first_.node_of[first_place];
    // What sticks out of a torus lies at its other end.
    const Rectangle& all = first_.nodes.front().place;
    const bool wraps = plan_.period_x != 0;
    const auto is_within = [&](std::uint32_t at, std::uint32_t begin, std::uint32_t end,
                               std::uint32_t all_begin, std::uint32_t all_end) {
        return (at - begin >= sample.radius || (!wraps && begin == all_begin)) &&
               (end - at > sample.radius || (!wraps && end == all_end));
    };
    for (;; node = first_.nodes[node].whole) {
        const Rectangle& place = first_.nodes[node].place;
        if (node == 0 ||
            (is_within(sample.x, place.x, place.x + place.width, all.x, all.x + all.width) &&
             is_within(sample.y, place.begin, place.end, all.begin, all.end)))
            return node;
    }
}

std::uint32_t NearLists::region_of(std::uint32_t first_place) const {
    const auto above = std::upper_bound(first_.begins.begin(), first_.begins.end(), first_place);
    return first_.regions[static_cast<std::size_t>(above - first_.begins.begin()) - 1];
}

template <typename Visit>
void NearLists::for_each_reached(const Sized& sample, std::uint32_t root, Visit visit) const {
    const std::uint32_t end = first_.nodes[root].next;
    const std::uint32_t radius = sample.radius & ~kMark;
    // Nothing in a part of the domain is nearer the other way around.
    const std::uint32_t period_x = root == 0 ? plan_.period_x : 0;
    const std::uint32_t period_y = root == 0 ? plan_.period_y : 0;
    for (std::uint32_t i = root; i < end;) {
        const FirstPlaces::Node& node = first_.nodes[i];
        const Rectangle& place = node.place;
        const std::uint64_t reach = std::min(radius, node.greatest);
        const std::uint32_t dx = distance_to(sample.x, place.x, place.x + place.width, period_x);
        const std::uint32_t dy = distance_to(sample.y, place.begin, place.end, period_y);
        if (portable::squared_length(dx, dy) >= reach * reach) {
            i = node.next;
            continue;
        }
        ++i;
        if (i == node.next) visit(node.first);
    }
}

void NearLists::insert_below(const Sized& sample, std::uint32_t root) {
    constexpr std::size_t kFirstRoom = 12;  // as many as most lists end with
    for_each_reached(sample, root, [&](std::uint32_t place) {
        if (lists_[place].empty()) lists_[place].reserve(kFirstRoom);
        lists_[place].push_back(sample);
    });
}

void NearLists::erase_marks(const Sized& mark, std::uint32_t first_place) {
    for_each_reached(mark, region_of(first_place), [&](std::uint32_t place) {
        std::erase_if(lists_[place], [](const Sized& sized) { return sized.radius >= kMark; });
    });
}

std::vector<Sample> NearLists::samples() const {
    std::vector<Sample> all;
    for (const std::vector<Sized>& list : lists_)
        for (const Sized& sized : list) all.push_back({sized.x, sized.y});
    const auto rank = [](Sample sample) { return std::uint64_t{sample.x} << 32 | sample.y; };
    std::sort(all.begin(), all.end(), [&](Sample a, Sample b) { return rank(a) < rank(b); });
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace lacuna::cpu
