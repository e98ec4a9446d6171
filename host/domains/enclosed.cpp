// Only rings whose outlines meet are cut by Clipper, and only where two of them overlap. All others
// stay as they are, to the last bit.
#include "domains/enclosed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "base/polling.h"
#include "domains/clip.h"
#include "domains/meetings.h"
#include "domains/rings.h"

namespace lacuna {
namespace domains {
namespace {

using ClipperLib::cInt;

// Whether there is more than rounding may leave: slivers some units wide.
bool is_something(const Paths& paths) {
    constexpr double kUnits = 4;
    return std::any_of(paths.begin(), paths.end(), [](const Path& path) {
        double around = 0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const auto &from = path[i], &to = path[(i + 1) % path.size()];
            around +=
                std::hypot(static_cast<double>(to.X - from.X), static_cast<double>(to.Y - from.Y));
        }
        return std::abs(ClipperLib::Area(path)) > kUnits * around;
    });
}

// The part of a ring where `sign` times a coordinate is at most `most` (Sutherland & Hodgman).
// Where it leaves and comes back, edges along the border join it.
Path cut_at(const Path& ring, cInt ClipperLib::IntPoint::*along, int sign, cInt most) {
    Path part;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const ClipperLib::IntPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        const cInt from = most - sign * a.*along, to = most - sign * b.*along;
        if (from >= 0) part.push_back(a);
        if ((from >= 0) == (to >= 0)) continue;
        const double share = static_cast<double>(from) / static_cast<double>(from - to);
        const auto between = [share](cInt start, cInt end) {
            return start + std::llrint(share * static_cast<double>(end - start));
        };
        ClipperLib::IntPoint at(between(a.X, b.X), between(a.Y, b.Y));
        at.*along = sign * most;
        part.push_back(at);
    }
    return part;
}

// The part of a ring in a box and a little around it.
Path part_in(const Box& box, Path ring) {
    constexpr cInt kMargin = 64;
    ask_after(ring.size());
    using ClipperLib::IntPoint;
    ring = cut_at(ring, &IntPoint::X, 1, box.high.X + kMargin);
    ring = cut_at(ring, &IntPoint::X, -1, kMargin - box.low.X);
    ring = cut_at(ring, &IntPoint::Y, 1, box.high.Y + kMargin);
    return cut_at(ring, &IntPoint::Y, -1, kMargin - box.low.Y);
}

Paths combined(ClipperLib::ClipType kind, const Paths& a, const Paths& b) {
    ask();
    ClipperLib::Clipper clipper;
    clipper.AddPaths(a, ClipperLib::ptSubject, true);
    clipper.AddPaths(b, ClipperLib::ptClip, true);
    Paths all;
    clipper.Execute(kind, all, ClipperLib::pftEvenOdd, ClipperLib::pftNonZero);
    return all;
}

// The rings of one polygon or file. Rings that overlap are put into one group.
class RingGroups {
public:
    explicit RingGroups(std::vector<PolygonRing> rings)
        : rings_(std::move(rings)), met_(domains::meetings(rings_)), group_(rings_.size()) {
        std::iota(group_.begin(), group_.end(), std::size_t{0});
        if (met_.empty()) return;
        exponent_ = exponent_for(largest_of(rings_));
        for (const PolygonRing& ring : rings_) {
            whole_.push_back(whole_path(ring, exponent_));
            boxes_.emplace_back().add(whole_.back());
        }
    }

    const std::vector<PolygonRing>& all() const { return rings_; }
    const RingPairs& met() const { return met_; }
    bool have_met(std::size_t a, std::size_t b) const { return met_.contains(std::minmax(a, b)); }

    bool overlap(std::size_t a, std::size_t b) const {
        return is_something(combined(ClipperLib::ctIntersection, {part_in(boxes_[b], whole_[a])},
                                     united({part_in(boxes_[a], whole_[b])})));
    }
    // Whether all that is in ring b is in ring a.
    bool covers(std::size_t a, std::size_t b) const {
        constexpr cInt kRounding = 4;
        const Box &outer = boxes_[a], &inner = boxes_[b];
        if (inner.low.X < outer.low.X - kRounding || inner.low.Y < outer.low.Y - kRounding ||
            inner.high.X > outer.high.X + kRounding || inner.high.Y > outer.high.Y + kRounding)
            return false;
        return !is_something(
            combined(ClipperLib::ctDifference, {whole_[b]}, united({part_in(inner, whole_[a])})));
    }

    void put_together(std::size_t a, std::size_t b) {
        const std::size_t low = std::min(group_of(a), group_of(b));
        group_[group_of(a)] = group_[group_of(b)] = low;
    }
    // The number of the first ring of its group.
    std::size_t group_of(std::size_t ring) const {
        while (group_[ring] != ring) ring = group_[ring];
        return ring;
    }
    // The members of each group among these rings, by the number of its first ring.
    std::map<std::size_t, std::vector<std::size_t>> groups(
        std::span<const std::size_t> rings) const {
        std::map<std::size_t, std::vector<std::size_t>> all;
        for (const std::size_t ring : rings) all[group_of(ring)].push_back(ring);
        return all;
    }

    // The union of some rings, each by the even-odd rule.
    Paths union_of(std::span<const std::size_t> members) const {
        Paths all;
        for (const std::size_t ring : members) {
            Paths own = united({whole_[ring]});
            std::move(own.begin(), own.end(), std::back_inserter(all));
        }
        return domains::united(all, ClipperLib::pftNonZero);
    }
    Paths shell_less(std::span<const std::size_t> holes) const {
        return combined(ClipperLib::ctDifference, {whole_.front()}, union_of(holes));
    }
    void put(const Paths& paths, std::vector<PolygonRing>& to) const {
        for (const Path& path : paths) to.push_back(ring_of(path, exponent_));
    }

private:
    static Paths united(const Paths& paths) {
        return domains::united(paths, ClipperLib::pftEvenOdd);
    }

    std::vector<PolygonRing> rings_;
    RingPairs met_;
    std::vector<std::size_t> group_;  // of each ring a lower one of its group, or itself
    int exponent_ = 0;
    // For each ring. Both are empty if no rings meet.
    Paths whole_;
    std::vector<Box> boxes_;
};

// Removes the holes that have no effect because they lie apart from the shell or in another hole.
// False if the shell lies in a hole.
bool remove_idle_holes(const RingGroups& rings, std::vector<std::size_t>& left) {
    const std::vector<std::vector<std::size_t>> around = rings_around(rings.all());
    const auto lies_in_hole = [&](std::size_t ring) {
        return std::any_of(around[ring].begin(), around[ring].end(), [&](std::size_t other) {
            return other != 0 && !rings.have_met(ring, other);
        });
    };
    const auto is_idle = [&](std::size_t ring) {
        if (ring == 0) return false;
        const bool is_apart =
            !rings.have_met(0, ring) &&
            std::find(around[ring].begin(), around[ring].end(), 0) == around[ring].end();
        return is_apart || lies_in_hole(ring);
    };
    left.erase(std::remove_if(left.begin(), left.end(), is_idle), left.end());
    return !lies_in_hole(0);
}

}  // namespace

std::vector<PolygonRing> shell_less_holes(std::vector<PolygonRing> given) {
    if (given.size() < 2) return given;
    RingGroups rings(std::move(given));
    for (const auto& [a, b] : rings.met())
        if (a == 0 ? !rings.covers(a, b) : rings.overlap(a, b)) rings.put_together(a, b);
    std::vector<std::size_t> left(rings.all().size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    if (!remove_idle_holes(rings, left)) return {};
    std::vector<PolygonRing> all;
    for (const auto& [first, members] : rings.groups(left)) {
        if (members.size() == 1) {
            all.push_back(rings.all()[members.front()]);
            continue;
        }
        const Paths paths =
            first == 0 ? rings.shell_less(std::span(members).subspan(1)) : rings.union_of(members);
        if (first == 0 && paths.empty()) return {};
        rings.put(paths, all);
    }
    return all;
}

}  // namespace domains

std::vector<PolygonRing> joined(std::vector<PolygonRing> given) {
    for (const PolygonRing& ring : given)
        if (!std::all_of(ring.begin(), ring.end(), domains::is_fair)) return given;
    // Points and lines enclose nothing.
    const auto lines = std::stable_partition(
        given.begin(), given.end(), [](const PolygonRing& ring) { return ring.size() > 2; });
    std::vector<PolygonRing> all(std::make_move_iterator(lines),
                                 std::make_move_iterator(given.end()));
    given.erase(lines, given.end());
    domains::RingGroups rings(std::move(given));
    for (const auto& [a, b] : rings.met())
        if (rings.overlap(a, b) && rings.covers(a, b) == rings.covers(b, a))
            rings.put_together(a, b);
    std::vector<std::size_t> numbers(rings.all().size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    for (const auto& [first, members] : rings.groups(numbers)) {
        if (members.size() == 1)
            all.push_back(rings.all()[first]);
        else
            rings.put(rings.union_of(members), all);
    }
    return all;
}

}  // namespace lacuna
