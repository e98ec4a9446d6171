// Down the tree of first places.
#include "backends/cpu/near_lists.h"

#include <algorithm>
#include <utility>

#include "plan/ground.h"

namespace lacuna::cpu {
namespace {

// Whether the sample is closer to the place than both its own radius and the greatest under it.
bool is_reached(const Rectangle& place, std::uint32_t greatest, const Sized& sample,
                std::uint32_t period_x, std::uint32_t period_y) {
    const std::uint64_t reach = std::min(sample.radius, greatest);
    return portable::squared_length(
               portable::distance_to_stretch(sample.x, place.x, place.x + place.width, period_x),
               portable::distance_to_stretch(sample.y, place.begin, place.end, period_y)) <
           reach * reach;
}

}  // namespace

NearLists::NearLists(const Plan& plan)
    : plan_(plan),
      first_(*plan.first_places),
      lists_(first_.places.size()),
      marked_(lists_.size()) {
    for (const auto& [at, radius] : plan.kept) insert_below({at.x, at.y, radius, 0}, 0);
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
    // Nothing in a part of the domain is nearer the other way around.
    const std::uint32_t period_x = root == 0 ? plan_.period_x : 0;
    const std::uint32_t period_y = root == 0 ? plan_.period_y : 0;
    for (std::uint32_t i = root; i < end;) {
        const FirstPlaces::Node& node = first_.nodes[i];
        if (!is_reached(node.place, node.greatest, sample, period_x, period_y)) {
            i = node.next;
            continue;
        }
        ++i;
        if (i == node.next) visit(node.first);
    }
}

void NearLists::insert_below(const Sized& sample, std::uint32_t root) {
    for_each_reached(sample, root, [&](std::uint32_t place) {
        constexpr std::size_t kFirstRoom = 12;  // as many as most lists end with
        List& list = lists_[place];
        if (list.near.capacity() == 0 && !list.split) list.near.reserve(kFirstRoom);
        add(list, first_.places[place], sample);
    });
}

bool NearLists::reaches(const Sized& sample, const Rectangle& place, std::uint32_t greatest) const {
    return is_reached(place, greatest, sample, plan_.period_x, plan_.period_y);
}

void NearLists::add(List& list, const Rectangle& place, const Sized& sample) {
    if (!list.split) {
        list.near.push_back(sample);
        if (list.near.size() > list.most) split(list, place);
        return;
    }
    for (Half* const half : {&list.split->low, &list.split->high})
        if (reaches(sample, half->place, half->greatest)) add(half->list, half->place, sample);
}

// Unless one half would have most of it.
void NearLists::split(List& list, const Rectangle& place) {
    const std::uint32_t height = place.end - place.begin;
    const std::uint32_t x = place.x + place.width / 2;
    const std::uint32_t y = place.begin + height / 2;
    list.most *= 2;
    if (std::max(place.width, height) < 2) return;
    auto parts = std::make_unique<Split>();
    if (place.width >= height) {
        parts->low.place = {place.x, x - place.x, place.begin, place.end};
        parts->high.place = {x, place.x + place.width - x, place.begin, place.end};
    } else {
        parts->low.place = {place.x, place.width, place.begin, y};
        parts->high.place = {place.x, place.width, y, place.end};
    }
    for (Half* const half : {&parts->low, &parts->high}) {
        half->greatest = plan_.ground->under(half->place).greatest;
        for (const Sized& sample : list.near)
            if (reaches(sample, half->place, half->greatest)) half->list.near.push_back(sample);
        half->list.most = std::max(half->list.most, 2 * half->list.near.size());
    }
    if (4 * std::max(parts->low.list.near.size(), parts->high.list.near.size()) >
        3 * list.near.size())
        return;
    list.near = {};
    list.split = std::move(parts);
}

void NearLists::gather(const List& list, const Rectangle& part, std::optional<std::uint32_t> round,
                       std::vector<Sized>& found) {
    if (!list.split) {
        for (const Sized& sample : list.near)
            if (!round || sample.round == *round) found.push_back(sample);
        return;
    }
    const Rectangle& high = list.split->high.place;
    if (part.x < high.x || part.begin < high.begin)
        gather(list.split->low.list, part, round, found);
    if (part.x + part.width > high.x && part.end > high.begin)
        gather(list.split->high.list, part, round, found);
}

std::span<const Sized> NearLists::of_part(std::uint32_t first_place, const Rectangle& part,
                                          std::optional<std::uint32_t> round,
                                          std::vector<Sized>& scratch) const {
    const List& list = lists_[first_place];
    if (!list.split) {
        // The latest stand last.
        const std::span<const Sized> near = list.near;
        std::size_t begin = round ? near.size() : 0;
        while (round && begin > 0 && near[begin - 1].round == *round) --begin;
        return near.subspan(begin);
    }
    scratch.clear();
    gather(list, part, round, scratch);
    return scratch;
}

void NearLists::mark(const Sized& candidate, std::uint32_t first_place, bool is_marked) {
    for_each_reached(candidate, region_of(first_place),
                     [&](std::uint32_t place) { marked_[place] = is_marked ? 1 : 0; });
}

std::vector<Sample> NearLists::samples() const {
    std::vector<Sample> all;
    std::vector<Sized> found;
    for (std::size_t place = 0; place < lists_.size(); ++place)
        gather(lists_[place], first_.places[place], {}, found);
    all.reserve(found.size());
    for (const Sized& sized : found) all.push_back({sized.x, sized.y});
    const auto rank = [](Sample sample) { return std::uint64_t{sample.x} << 32 | sample.y; };
    std::sort(all.begin(), all.end(), [&](Sample a, Sample b) { return rank(a) < rank(b); });
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace lacuna::cpu
