// Halving, along the longer side or the border of pixels next to its middle.
#include "plan/first_places.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "large_pages.h"
#include "plan/ground.h"

namespace lacuna {
namespace {

// Work is shared out evenly enough when no region has more than one place in so many; and one of
// fewer places than kFewPlaces is not worth sharing out.
constexpr std::uint32_t kRegions = 96;
constexpr std::uint32_t kFewPlaces = 128;

// Places are at most so many of the least radius under them long, over the plan's lines_per_radius.
// Shorter ones are cut, and samples listed, more often; of longer ones every look takes longer.
constexpr std::uint32_t kRadii = 2;

class Halving {
public:
    explicit Halving(const Plan& plan) : ground_(*plan.ground), pieces_(plan.lines_per_radius) {
        // About as many as there are places; memory that is not used is not touched.
        const std::size_t places = plan.maximal_samples;
        first_.places.reserve(places);
        first_.even_radii.reserve(places);
        first_.node_of.reserve(places);
        first_.nodes.reserve(2 * places);
        ask_for_large_pages(first_.nodes.data(), 2 * places);
    }

    void cut(const Rectangle& place, std::size_t whole) {
        const Under under = ground_.under(place);
        if (under.least == 0) return;
        const std::size_t node = first_.nodes.size();
        first_.nodes.push_back(
            {place, under.greatest, 0, count(), static_cast<std::uint32_t>(whole)});
        const std::uint32_t height = place.end - place.begin;
        const std::uint64_t longer = std::max(place.width, height);
        if (longer == 1 || longer * pieces_ <= kRadii * std::uint64_t{under.least}) {
            first_.places.push_back(place);
            first_.node_of.push_back(static_cast<std::uint32_t>(node));
            first_.even_radii.push_back(under.is_even ? under.least : 0);
        } else if (place.width >= height) {
            cut_at_x(place, node, under.is_even ? place.x + place.width / 2 : ground_.cut_x(place));
        } else {
            cut_at_y(place, node, under.is_even ? 0 : ground_.cut_y(place));
        }
        // Of a large rectangle it may show in its parts only that none of it is allowed.
        if (first_.nodes[node].first == count()) first_.nodes.resize(node);
        if (first_.nodes.size() > node)
            first_.nodes[node].next = static_cast<std::uint32_t>(first_.nodes.size());
    }

    FirstPlaces take() {
        const std::uint32_t most = std::max(kFewPlaces, count() / kRegions);
        for (std::uint32_t i = 0; i < first_.nodes.size();) {
            const FirstPlaces::Node& node = first_.nodes[i];
            const std::uint32_t end =
                node.next < first_.nodes.size() ? first_.nodes[node.next].first : count();
            if (end - node.first > most) {
                ++i;
                continue;
            }
            if (end > node.first) {
                first_.regions.push_back(i);
                first_.begins.push_back(node.first);
            }
            i = node.next;
        }
        first_.begins.push_back(count());
        return std::move(first_);
    }

private:
    std::uint32_t count() const { return static_cast<std::uint32_t>(first_.places.size()); }

    void cut_at_x(const Rectangle& place, std::size_t node, std::uint32_t x) {
        cut({place.x, x - place.x, place.begin, place.end}, node);
        cut({x, place.x + place.width - x, place.begin, place.end}, node);
    }
    void cut_at_y(const Rectangle& place, std::size_t node, std::uint32_t y) {
        if (y == 0) y = place.begin + (place.end - place.begin) / 2;
        cut({place.x, place.width, place.begin, y}, node);
        cut({place.x, place.width, y, place.end}, node);
    }

    const Ground& ground_;
    std::uint32_t pieces_;
    FirstPlaces first_;
};

}  // namespace

FirstPlaces first_places(const Plan& plan) {
    const Ground::Shape& shape = plan.ground->shape();
    Halving halving(plan);
    halving.cut({shape.low_x, shape.high_x - shape.low_x, shape.low_y, shape.high_y}, 0);
    return halving.take();
}

}  // namespace lacuna
