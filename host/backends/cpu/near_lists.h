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

#include "large_pages.h"
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
};

class NearLists {
public:
    explicit NearLists(const Plan& plan);

    // Those that may take something from a part of a first place, some perhaps twice; or only those
    // that were listed since it was settled. Valid until the next call with the same scratch.
    enum class Which { all, latest };
    std::span<const Sized> of_part(std::uint32_t first_place, const Rectangle& part, Which which,
                                   std::vector<Sized>& scratch) const {
        const Few& few = few_[first_place];
        if (few.is_long) return of_long_part(first_place, part, which, scratch);
        const std::size_t begin = which == Which::latest ? few.settled : 0;
        return {few.near + begin, few.count - begin};
    }

    // Whether any was listed since the first place was settled, or ever; and settles it.
    bool has_latest(std::uint32_t first_place) const {
        return (states_[first_place] & kLatest) != 0;
    }
    void settle(std::uint32_t first_place);
    // Nothing is left of the first place: no more samples are listed for it.
    void close(std::uint32_t first_place) { states_[first_place] |= kClosed; }

    // Whether a sample in the list of a first place keeps one with this radius from lying at a
    // point of that place: it is closer than the smaller of both radii.
    bool is_any_closer(std::uint32_t first_place, Sample at, std::uint32_t radius) const {
        const Few& few = few_[first_place];
        return is_any_closer(
            few.is_long ? long_part(first_place, at) : std::span<const Sized>(few.near, few.count),
            at, radius);
    }

    // Ask the cache for a list, and for what insert begins with: first for where it is.
    void fetch_list(std::uint32_t first_place) const {
        __builtin_prefetch(&few_[first_place]);
        __builtin_prefetch(&few_[first_place].near[kFew - 1]);
    }
    void fetch_way_to_node(std::uint32_t first_place) const {
        __builtin_prefetch(&first_.node_of[first_place]);
    }
    void fetch_node(std::uint32_t first_place) const {
        const FirstPlaces::Node* const node = &first_.nodes[first_.node_of[first_place]];
        __builtin_prefetch(node - 2);
        __builtin_prefetch(node);
        __builtin_prefetch(node + 2);
    }
    // Lists what lies in a first place for all of them that it reaches, but closed ones. In
    // parallel for different regions, if it reaches those of its region only.
    void insert(const Sized& sample, std::uint32_t first_place);
    // Marks the first places of its own region that it reaches, or takes their marks away. Places
    // are marked as a whole: in a round that crowds, thousands would leave a mark in one.
    void mark(const Sized& candidate, std::uint32_t first_place, bool is_marked);
    bool is_marked(std::uint32_t first_place) const {
        return (states_[first_place] & kMarked) != 0;
    }

    // By x, then y.
    std::vector<Sample> samples() const;

private:
    // As many as nearly all lists end with, in two lines of the cache.
    static constexpr std::size_t kFew = 10;
    struct alignas(64) Few {
        std::uint16_t count;
        std::uint16_t settled;  // how many of them were listed when the place was settled
        bool is_long;           // they are in long_
        Sized near[kFew];
    };
    static constexpr std::uint8_t kMarked = 1, kLatest = 2, kClosed = 4;

    // A place beside one of far smaller radii may have thousands near it: a list of more than
    // `most` is split in two, each for one half of the place.
    struct Split;
    struct List {
        std::vector<Sized> near;
        std::size_t settled = 0;
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
    bool is_any_closer(std::span<const Sized> all, Sample at, std::uint32_t radius) const {
        bool is_closer = false;
        if (plan_.period_x == 0)
            for (const Sized& near : all) {
                const std::uint64_t limit = std::min(near.radius, radius);
                is_closer |= portable::conflicts_on_box(near.x, near.y, at.x, at.y, limit * limit);
            }
        else
            for (const Sized& near : all) {
                const std::uint64_t limit = std::min(near.radius, radius);
                is_closer |= portable::conflicts(near.x, near.y, at.x, at.y, plan_.period_x,
                                                 plan_.period_y, limit * limit);
            }
        return is_closer;
    }
    std::span<const Sized> of_long_part(std::uint32_t first_place, const Rectangle& part,
                                        Which which, std::vector<Sized>& scratch) const;
    std::span<const Sized> long_part(std::uint32_t first_place, Sample at) const;
    bool reaches(const Sized& sample, const Rectangle& place, std::uint32_t greatest) const;
    void push(const Sized& sample, std::uint32_t first_place);
    void push_long(const Sized& sample, std::uint32_t first_place);
    void add(List& list, const Rectangle& place, const Sized& sample);
    void split(List& list, const Rectangle& place);
    static void settle(List& list);
    static void gather(const List& list, const Rectangle& part, Which which,
                       std::vector<Sized>& found);

    // Whether all first places that it reaches lie in the node, whose torus it does not stick out
    // of.
    bool is_within(const Sized& sample, std::uint32_t node) const;
    bool sticks_out(const Sized& sample) const;
    std::uint32_t region_of(std::uint32_t first_place) const;
    template <typename Visit>
    void for_each_reached(const Sized& sample, std::uint32_t root, Visit visit) const;

    const Plan& plan_;
    const FirstPlaces& first_;
    ZeroedArray<Few> few_;
    std::vector<std::unique_ptr<List>> long_;
    std::vector<std::uint8_t> states_;
};

}  // namespace lacuna::cpu
