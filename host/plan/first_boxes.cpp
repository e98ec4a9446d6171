// Cuts boxes across their longer side: at a border of pixels near its middle, or in the middle.
#include "plan/first_boxes.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/large_pages.h"
#include "base/polling.h"
#include "plan/radius_field.h"

namespace lacuna {
namespace {

// A region is work for one thread and has at most 1/kRegions of the boxes, so that work is even. A
// region of fewer than kFewBoxes boxes is not cut further, because that would save no time.
constexpr std::uint32_t kRegions = 96;
constexpr std::uint32_t kFewBoxes = 128;

// A box is at most kRadii / lines_per_radius of the least radius under it long. With shorter boxes
// there are more to cut; with longer ones more draws fall into covered space.
constexpr std::uint32_t kRadii = 2;
// A block is at most kRadiiOfBlock of the least radius long. With shorter blocks a sample is in
// more lists; with longer ones each list takes longer to search.
constexpr std::uint32_t kRadiiOfBlock = 6;

class Halving {
public:
    Halving(const Plan& plan, const PlacesOfClasses& places)
        : radius_field_(*plan.field().radius_field),
          copies_(plan.field().copies),
          places_(places),
          pieces_(plan.lines_per_radius) {
        // Reserves about as many as there will be boxes. Memory that stays unused is never touched.
        const std::size_t boxes = plan.maximal_samples;
        first_.boxes.reserve(boxes);
        ask_for_large_pages(first_.boxes.data(), boxes);
        first_.blocks.reserve(boxes);
        first_.nodes.reserve(2 * boxes);
        ask_for_large_pages(first_.nodes.data(), 2 * boxes);
    }

    // With several classes, node 0 has the copies of all as its parts.
    void cut_copies(const Box& domain) {
        if (!copies_.are_several()) return cut_copy(0, domain);
        const std::uint32_t last = copies_.begin_of(copies_.count() - 1);
        first_.nodes.push_back({{domain.x, last + domain.width, domain.begin, domain.end},
                                radius_field_.under(domain).greatest,
                                0,
                                0,
                                0});
        for (std::uint32_t copy = 0; copy < copies_.count(); ++copy)
            if (copies_.weight(copy) != 0) cut_copy(copy, domain);
        first_.nodes.front().next = static_cast<std::uint32_t>(first_.nodes.size());
    }

    void cut_copy(std::uint32_t copy, const Box& domain) {
        const std::size_t node = first_.nodes.size();
        factor_ = copies_.factor_of_boxes(copy);
        own_ = places_.empty() ? nullptr : places_[copy].get();
        cut({copies_.x_on(copy, domain.x), domain.width, domain.begin, domain.end}, 0);
        if (first_.nodes.size() > node) first_.copies.push_back(static_cast<std::uint32_t>(node));
    }

    void cut(const Box& box, std::size_t whole) {
        ask_after(8);
        const Under under = radius_field_.under(box);
        if (under.least == 0 || is_closed(within_border(box))) return;
        const std::size_t node = first_.nodes.size();
        const std::uint32_t block = blocks();
        first_.nodes.push_back({box, under.greatest, 0, block, static_cast<std::uint32_t>(whole)});
        if (is_short(box, under, kRadiiOfBlock) || is_short(box, under, kRadii, pieces_)) {
            const std::uint32_t first = boxes();
            cut_block(box, under);
            if (boxes() > first)
                first_.blocks.push_back({first, under.is_even ? under.greatest : 0,
                                         static_cast<std::uint32_t>(node), under.least});
        } else {
            cut_in_two(radius_field_, box, under, [&](const Box& part) { cut(part, node); });
        }
        // If nothing in a large box is allowed, this may show in its parts only: its nodes are
        // removed.
        if (block == blocks())
            first_.nodes.resize(node);
        else
            first_.nodes[node].next = static_cast<std::uint32_t>(first_.nodes.size());
    }

    FirstBoxes take() {
        most_in_region_ = std::max(kFewBoxes, boxes() / kRegions);
        first_.blocks.push_back({boxes(), 0, 0, 0});
        if (!first_.copies.empty()) cut_zone(first_.copies);
        for (std::size_t copy = 0; copy < first_.copies.size(); ++copy)
            for (FirstBoxes::Zone& zone : first_.zones) find_regions(zone.nodes[copy], zone);
        first_.begins.push_back(boxes());
        return std::move(first_);
    }

private:
    // A zone of one class is small enough to be a region, unless other classes ended its cutting.
    void find_regions(std::uint32_t root, FirstBoxes::Zone& zone) {
        const std::uint32_t all = first_.nodes[root].next;
        for (std::uint32_t i = root; i < all;) {
            if (boxes_in(i) > most_in_region_ && i + 1 < first_.nodes[i].next) {
                ++i;
                continue;
            }
            zone.regions.push_back(static_cast<std::uint32_t>(first_.regions.size()));
            first_.begins.push_back(first_.blocks[first_.nodes[i].first].first);
            first_.regions.push_back(i);
            i = first_.nodes[i].next;
        }
    }

    // `nodes` is the same part of the domain on each copy. It is cut where one of the nodes is
    // more than a region, and all have the same parts.
    void cut_zone(const std::vector<std::uint32_t>& nodes) {
        std::vector<std::vector<std::uint32_t>> parts;  // of the domain, each on all copies
        bool is_large = false, are_like = true;
        for (const std::uint32_t node : nodes) {
            is_large |= boxes_in(node) > most_in_region_;
            std::size_t count = 0;
            for (std::uint32_t i = node + 1; i < first_.nodes[node].next; ++count) {
                if (node == nodes.front()) parts.emplace_back();
                are_like &= count < parts.size();
                if (!are_like) break;
                parts[count].push_back(i);
                are_like &= are_alike(parts[count].front(), i);
                i = first_.nodes[i].next;
            }
            are_like &= count == parts.size() && count != 0;
        }
        if (is_large && are_like)
            for (const std::vector<std::uint32_t>& part : parts) cut_zone(part);
        else
            first_.zones.push_back({nodes, {}});
    }

    bool are_alike(std::uint32_t a, std::uint32_t b) const {
        const auto on_domain = [&](Box box) {
            box.x = copies_.x_on_copy(box.x);
            return box;
        };
        return on_domain(first_.nodes[a].box) == on_domain(first_.nodes[b].box);
    }
    std::uint32_t boxes_in(std::uint32_t index) const {
        const FirstBoxes::Node& node = first_.nodes[index];
        return first_.blocks[block_after(node)].first - first_.blocks[node.first].first;
    }

    std::uint32_t boxes() const { return static_cast<std::uint32_t>(first_.boxes.size()); }
    std::uint32_t blocks() const { return static_cast<std::uint32_t>(first_.blocks.size()); }

    // How long the sides of a box are beside a radius. Where all samples have one ellipse: after
    // the map that makes the ellipse a circle (portable/ellipse.h).
    struct Sides {
        std::uint64_t along_x;
        std::uint64_t along_y;
        std::uint64_t radius;
    };
    Sides sides_of(const Box& box, const Under& under) const {
        const std::uint64_t width = box.width, height = box.end - box.begin;
        if (!radius_field_.has_ellipses() || !under.is_even)
            return {width, height, portable::times_factor(under.least, factor_)};
        const portable::Ellipse& e = radius_field_.ellipse_at(box.x, box.begin);
        const std::uint64_t across = std::uint64_t{e.p} * e.p;
        const std::uint64_t aside = portable::magnitude(portable::sign_extended(e.q));
        return {width * portable::isqrt(across + aside * aside) >> e.shift, height * e.s >> e.shift,
                ELLIPSE_RADIUS};
    }

    bool is_short(const Box& box, const Under& under, std::uint64_t radii,
                  std::uint64_t pieces = 1) const {
        const Sides sides = sides_of(box, under);
        return std::max(box.width, box.end - box.begin) == 1 ||
               std::max(sides.along_x, sides.along_y) * pieces <= radii * sides.radius;
    }

    // The part of a box that lies within the border of the copy's class.
    Box within_border(const Box& box) const {
        if (own_ == nullptr) return box;
        const RadiusField::Shape& shape = own_->shape();
        const std::uint32_t copy = box.x - copies_.x_on_copy(box.x);
        const std::uint32_t x = std::max(box.x, copy + shape.low_x);
        const std::uint32_t end = std::max(x, std::min(box.x + box.width, copy + shape.high_x));
        return {x, end - x, std::max(box.begin, shape.low_y), std::min(box.end, shape.high_y)};
    }
    // Whether the class of the copy has places of its own, and none of them is in the box.
    bool is_closed(const Box& box) const {
        return own_ != nullptr &&
               (box.width == 0 || box.begin >= box.end || own_->under(box).least == 0);
    }

    void cut_block(const Box& whole, const Under& under) {
        const Box box = within_border(whole);
        if (under.least == 0 || is_closed(box)) return;
        if (is_short(box, under, kRadii, pieces_)) return add_box(box);
        cut_in_two(radius_field_, box, under,
                   [&](const Box& part) { cut_block(part, radius_field_.under(part)); });
    }

    // Cuts a box along the mask of its class, if that has one of its own, down to single pixels.
    void add_box(const Box& box) {
        if (is_closed(box)) return;
        if (own_ == nullptr || !own_->is_mask_mixed(box)) return first_.boxes.push_back(box);
        cut_in_two(*own_, box, own_->under(box), [&](const Box& part) { add_box(part); });
    }

    template <typename Take>
    void cut_in_two(const RadiusField& field, const Box& box, const Under& under, Take take) {
        const std::uint32_t height = box.end - box.begin;
        const Sides sides = sides_of(box, under);
        if (box.width > 1 && (height == 1 || sides.along_x >= sides.along_y)) {
            const std::uint32_t x = under.is_even ? box.x + box.width / 2 : field.cut_x(box);
            take(Box{box.x, x - box.x, box.begin, box.end});
            take(Box{x, box.x + box.width - x, box.begin, box.end});
        } else {
            std::uint32_t y = under.is_even ? 0 : field.cut_y(box);
            if (y == 0) y = box.begin + height / 2;
            take(Box{box.x, box.width, box.begin, y});
            take(Box{box.x, box.width, y, box.end});
        }
    }

    std::uint32_t block_after(const FirstBoxes::Node& node) const {
        return node.next < first_.nodes.size() ? first_.nodes[node.next].first : blocks() - 1;
    }

    const RadiusField& radius_field_;
    const ClassCopies& copies_;
    const PlacesOfClasses& places_;
    const RadiusField* own_ = nullptr;   // the places of the copy's class alone
    std::uint64_t factor_ = FACTOR_ONE;  // of the radii to which lengths are compared
    std::uint32_t pieces_;
    std::uint32_t most_in_region_ = 0;  // boxes
    FirstBoxes first_;
};

}  // namespace

std::vector<std::uint32_t> FirstBoxes::part_counts() const {
    std::vector<std::uint32_t> counts(nodes.size());
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        if (nodes[node].next == node + 1) counts[node] = 1;
        if (node != 0) ++counts[nodes[node].whole];
    }
    return counts;
}

FirstBoxes first_boxes(const Plan& plan, const PlacesOfClasses& places) {
    const RadiusField::Shape& shape = plan.field().radius_field->shape();
    Halving halving(plan, places);
    halving.cut_copies({shape.low_x, shape.high_x - shape.low_x, shape.low_y, shape.high_y});
    return halving.take();
}

}  // namespace lacuna
