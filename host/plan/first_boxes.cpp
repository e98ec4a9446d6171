// Cuts boxes across their longer side: at a border of pixels near its middle, or in the middle.
#include "plan/first_boxes.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/large_pages.h"
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
    explicit Halving(const Plan& plan)
        : radius_field_(*plan.field().radius_field), pieces_(plan.lines_per_radius) {
        // Reserves about as many as there will be boxes. Memory that stays unused is never touched.
        const std::size_t boxes = plan.maximal_samples;
        first_.boxes.reserve(boxes);
        ask_for_large_pages(first_.boxes.data(), boxes);
        first_.blocks.reserve(boxes);
        first_.nodes.reserve(2 * boxes);
        ask_for_large_pages(first_.nodes.data(), 2 * boxes);
    }

    void cut(const Box& box, std::size_t whole) {
        const Under under = radius_field_.under(box);
        if (under.least == 0) return;
        const std::size_t node = first_.nodes.size();
        const std::uint32_t block = blocks();
        first_.nodes.push_back({box, under.greatest, 0, block, static_cast<std::uint32_t>(whole)});
        if (is_short(box, under, kRadiiOfBlock) || is_short(box, under, kRadii, pieces_)) {
            const std::uint32_t first = boxes();
            cut_block(box, under);
            if (boxes() > first)
                first_.blocks.push_back(
                    {first, under.is_even ? under.least : 0, static_cast<std::uint32_t>(node)});
        } else {
            cut_in_two(box, under, [&](const Box& part) { cut(part, node); });
        }
        // If nothing in a large box is allowed, this may show in its parts only: its nodes are
        // removed.
        if (block == blocks())
            first_.nodes.resize(node);
        else
            first_.nodes[node].next = static_cast<std::uint32_t>(first_.nodes.size());
    }

    FirstBoxes take() {
        const std::uint32_t most = std::max(kFewBoxes, boxes() / kRegions);
        first_.blocks.push_back({boxes(), 0, 0});
        for (std::uint32_t i = 0; i < first_.nodes.size();) {
            const FirstBoxes::Node& node = first_.nodes[i];
            const std::uint32_t first = first_.blocks[node.first].first;
            const std::uint32_t end = first_.blocks[block_after(node)].first;
            if (end - first > most && i + 1 < node.next) {
                ++i;
                continue;
            }
            first_.regions.push_back(i);
            first_.begins.push_back(first);
            i = node.next;
        }
        first_.begins.push_back(boxes());
        return std::move(first_);
    }

private:
    std::uint32_t boxes() const { return static_cast<std::uint32_t>(first_.boxes.size()); }
    std::uint32_t blocks() const { return static_cast<std::uint32_t>(first_.blocks.size()); }

    static bool is_short(const Box& box, const Under& under, std::uint64_t radii,
                         std::uint64_t pieces = 1) {
        const std::uint64_t longer = std::max(box.width, box.end - box.begin);
        return longer == 1 || longer * pieces <= radii * under.least;
    }

    void cut_block(const Box& box, const Under& under) {
        if (under.least == 0) return;
        if (is_short(box, under, kRadii, pieces_)) return first_.boxes.push_back(box);
        cut_in_two(box, under,
                   [&](const Box& part) { cut_block(part, radius_field_.under(part)); });
    }

    template <typename Take>
    void cut_in_two(const Box& box, const Under& under, Take take) {
        const std::uint32_t height = box.end - box.begin;
        if (box.width >= height) {
            const std::uint32_t x =
                under.is_even ? box.x + box.width / 2 : radius_field_.cut_x(box);
            take(Box{box.x, x - box.x, box.begin, box.end});
            take(Box{x, box.x + box.width - x, box.begin, box.end});
        } else {
            std::uint32_t y = under.is_even ? 0 : radius_field_.cut_y(box);
            if (y == 0) y = box.begin + height / 2;
            take(Box{box.x, box.width, box.begin, y});
            take(Box{box.x, box.width, y, box.end});
        }
    }

    std::uint32_t block_after(const FirstBoxes::Node& node) const {
        return node.next < first_.nodes.size() ? first_.nodes[node.next].first : blocks() - 1;
    }

    const RadiusField& radius_field_;
    std::uint32_t pieces_;
    FirstBoxes first_;
};

}  // namespace

FirstBoxes first_boxes(const Plan& plan) {
    const RadiusField::Shape& shape = plan.field().radius_field->shape();
    Halving halving(plan);
    halving.cut({shape.low_x, shape.high_x - shape.low_x, shape.low_y, shape.high_y}, 0);
    return halving.take();
}

}  // namespace lacuna
