// The samples on a ground, listed for each of the first places that they reach
// (plan/first_places.h).
//
// A sample takes something from a place only where it is closer than its own radius and than the
// place's: so a tree of the first places, with the greatest radius under each node, leads to those
// that it reaches, whatever the range of radii.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plan/first_places.h"
#include "plan/pixels.h"
#include "plan/plan.h"
#include "portable/distance.h"

namespace lacuna::cpu {

// A sample with its radius.
struct Sized {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t radius;
    std::uint32_t round;  // in which it was admitted, or 0
};

class NearLists {
public:
    explicit NearLists(const Plan& plan);

    // Those that may take something from a part of a first place, some perhaps twice; with `round`
    // those of that round only. Valid until the next call with the same scratch.
    std::span<const Sized> of_part(std::uint32_t first_place, const Rectangle& part,
                                   std::optional<std::uint32_t> round,
                                   std::vector<Sized>& scratch) const;

    // Whether a sample in the list of a first place keeps one with this radius from lying at a
    // point of that place: it is closer than the smaller of both radii.
    bool is_any_closer(std::uint32_t first_place, Sample at, std::uint32_t radius) const {
        bool is_closer = false;
        const List* list = &lists_[first_place];
        while (list->split) list = &list->split->part_at(at);
        for (const Sized& near : list->near) {
            const std::uint64_t limit = std::min(near.radius, radius);
            is_closer |= portable::conflicts(near.x, near.y, at.x, at.y, plan_.period_x,
                                             plan_.period_y, limit * limit);
        }
        return is_closer;
    }

    // Lists what lies in a first place for all of them that it reaches. In parallel for different
    // regions, if it reaches those of its region only.
    void insert(const Sized& sample, std::uint32_t first_place) {
        insert_below(sample, node_around(sample, first_place));
    }
    // Marks the first places of its own region that it reaches, or takes their marks away. Places
    // are marked as a whole: in a round that crowds, thousands would leave a mark in one.
    void mark(const Sized& candidate, std::uint32_t first_place, bool is_marked);
    bool is_marked(std::uint32_t first_place) const { return marked_[first_place] != 0; }

    // By x, then y.
    std::vector<Sample> samples() const;

private:
    // A place beside one of far smaller radii may have thousands near it: a list of more than
    // `most` is split in two, each for one half of the place.
    struct Split;
    struct List {
        std::vector<Sized> near;
        std::unique_ptr<Split> split;
        std::size_t most = 64;
    };
    struct Half {
        Rectangle place;
        std::uint32_t greatest;  // radius under it
        List list;
    };
    struct Split {
        Half low;
        Half high;
        const List& part_at(Sample at) const {
            return at.x >= high.place.x && at.y >= high.place.begin ? high.list : low.list;
        }
    };
    bool reaches(const Sized& sample, const Rectangle& place, std::uint32_t greatest) const;
    void add(List& list, const Rectangle& place, const Sized& sample);
    void split(List& list, const Rectangle& place);
    static void gather(const List& list, const Rectangle& part, std::optional<std::uint32_t> round,
                       std::vector<Sized>& found);

    // The smallest node that holds all first places that it reaches.
    std::uint32_t node_around(const Sized& sample, std::uint32_t first_place) const;
    std::uint32_t region_of(std::uint32_t first_place) const;
    void insert_below(const Sized& sample, std::uint32_t root);
    template <typename Visit>
    void for_each_reached(const Sized& sample, std::uint32_t root, Visit visit) const;

    const Plan& plan_;
    const FirstPlaces& first_;
    std::vector<List> lists_;
    std::vector<char> marked_;
};

}  // namespace lacuna::cpu
