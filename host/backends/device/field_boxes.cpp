// The bins of mode exact with a radius field on a device: active boxes, which the samples in
// neighbour lists cut (docs/design.md, section 4).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "backends/device/bins.h"
#include "backends/device/list_boxes.h"
#include "backends/device/neighbour_lists.h"
#include "backends/field_snapshot.h"
#include "plan/first_boxes.h"
#include "plan/radius_field.h"
#include "portable/radius_field.h"

namespace lacuna::device {
namespace {

// The work of a draw, see Queue::launch.
constexpr std::uint64_t kFieldLocateWork = 2;
constexpr std::uint64_t kListScreenWork = 2;

// A radius field in words, as kernels read it (portable/radius_field.h), without its radii, which
// are words already.
struct FieldTables {
    std::vector<std::uint32_t> axes;
    std::vector<std::uint32_t> mask_nodes;  // NODE_WORDS each; without a mask one word
    std::vector<std::uint32_t> ellipses;    // four words for each pixel; without ellipses four
};

void append_axis(const PixelAxis& axis, std::uint32_t number, std::uint32_t last,
                 std::vector<std::uint32_t>& axes) {
    std::uint32_t* const words = &axes[number * std::size_t{AXIS_WORDS}];
    words[AXIS_PIXELS] = axis.pixels();
    words[AXIS_SHIFT] = axis.shift();
    words[AXIS_SCALE] = static_cast<std::uint32_t>(axis.scale());
    words[AXIS_SCALE + 1] = static_cast<std::uint32_t>(axis.scale() >> 32);
    words[AXIS_LAST] = last;
    words[AXIS_LENGTH] = axis.length();
}

FieldTables tables_of(const RadiusField& radius_field) {
    FieldTables tables;
    tables.axes.resize(4 * std::size_t{AXIS_WORDS}, 0);
    const std::uint32_t last = radius_field.shape().last_on_copy;
    constexpr std::uint32_t kAny = ~std::uint32_t{0};
    append_axis(radius_field.columns(), COLUMNS_OF_FIELD, last, tables.axes);
    append_axis(radius_field.rows(), ROWS_OF_FIELD, kAny, tables.axes);
    for (const auto& [p, q, s, shift] : radius_field.ellipses())
        tables.ellipses.insert(tables.ellipses.end(), {p, q, s, shift});
    if (!radius_field.has_ellipses()) tables.ellipses.resize(4);
    tables.mask_nodes = {0};
    if (radius_field.mask() == nullptr) return tables;
    append_axis(*radius_field.mask_columns(), COLUMNS_OF_MASK, last, tables.axes);
    append_axis(*radius_field.mask_rows(), ROWS_OF_MASK, kAny, tables.axes);
    const MaskTree& mask = *radius_field.mask();
    tables.axes[COLUMNS_OF_MASK * std::size_t{AXIS_WORDS} + AXIS_ROOT] = mask.root();
    tables.mask_nodes.clear();
    for (const auto& [values, first] : mask.nodes())
        tables.mask_nodes.insert(tables.mask_nodes.end(), {values, first});
    return tables;
}

class FieldBoxes : public Bins {
public:
    explicit FieldBoxes(RoundMemory& round)
        : Bins(round), first_(*round.plan.field().first_boxes), boxes_(round), lists_(round) {
        make_tables();
        put_first_boxes();
        find_disk_areas();
        lists_.put(round_.plan.field().kept);
    }

    PartLimits part_limits(std::uint32_t count) const override {
        return limits_by_area(count, mean_disk_area_, widest_disk_area_);
    }

    void begin_part() override {
        round_.make_room(round_.memory.candidate_radii, round_.draw_count);
        lists_.begin_part();
    }

    void locate(std::span<const Draw>) override {
        round_.launch_over_draws<kernels::locate_with_field>(round_.arguments(), kFieldLocateWork);
    }

    void screen(Range draws, std::uint32_t status, bool opens) override {
        const bool is_listed = opens && round_.parts() == 1;
        if (is_listed) lists_.begin_survivors();
        round_.screen<kernels::screen_with_field>(draws, status, kListScreenWork, is_listed);
    }

    void admit(std::uint32_t pass) override {
        lists_.list_visitors();
        round_.admit<kernels::admit_with_field>(round_.arguments(), pass,
                                                round_.queue.run_of(round_.part_count()));
    }

    void subtract() override { throw std::logic_error("with a radius field every round refines"); }
    void take_out() override { lists_.enlist(); }

    // Halves are cut by all samples in their lists; boxes that are not halved only by the round's.
    void refine(bool halve) override {
        take_out();
        boxes_.refine(halve, halve ? 0 : lists_.first_recent());
    }

    bool queue_rest() override { return boxes_.queue_rest(); }
    void download() override { boxes_.download(); }
    void end_round() override {
        boxes_.end_round();
        lists_.end_round();
    }

    std::span<const std::uint32_t> free_lengths() const override { return boxes_.free_lengths(); }
    std::uint32_t width() const override { return round_.plan.strip_width; }
    std::span<const std::uint32_t> widths() const override { return boxes_.widths(); }
    std::span<const std::uint32_t> copy_ends() const override { return boxes_.copy_ends(); }

    void snapshot(Snapshot& snapshot) override {
        snapshot.boxes = boxes_.get();
        snapshot.samples = lists_.get();
        sort_for_snapshot(snapshot.samples);
    }
    void restore(const Snapshot& snapshot) override {
        std::vector<std::uint32_t> origins;
        for (const Box& box : snapshot.boxes)
            append_origin(box, block_at(first_, box.x, box.begin), origins);
        boxes_.put(snapshot.boxes, origins);
        lists_.put(with_radii(round_.plan, snapshot.samples));
        lists_.end_round();  // these samples have cut the boxes
    }
    void put_candidates(std::vector<Candidate>& candidates) override {
        std::vector<std::uint32_t> radii;
        for (Candidate& candidate : candidates) {
            candidate.home = block_at(first_, candidate.x, candidate.y);
            radii.push_back(round_.plan.field().radius_field->radius_at(candidate.x, candidate.y));
        }
        round_.put_in_room<std::uint32_t>(round_.memory.candidate_radii, radii);
        Bins::put_candidates(candidates);
    }

private:
    void make_tables() {
        const FieldTables tables = tables_of(*round_.plan.field().radius_field);
        Memory& m = round_.memory;
        m.axes = round_.copy_of(tables.axes);
        m.mask_nodes = round_.copy_of(tables.mask_nodes);
        round_.put_in_room<std::uint64_t>(m.factors, round_.plan.field().copies.factors());
        m.ellipses = round_.copy_of(tables.ellipses);
        using Radii = RadiusField::Radii;
        static_assert(sizeof(Radii) == 2 * kWord);
        const RadiusField::RadiusPyramid& radii = round_.plan.field().radius_field->radii();
        std::vector<Radii> all;
        radii.for_each_level([&](std::span<const Radii> level) {
            all.insert(all.end(), level.begin(), level.end());
        });
        round_.put_in_room<Radii>(m.radius_bounds, all);
    }

    void put_first_boxes() {
        std::vector<std::uint32_t> origins;
        const auto count = static_cast<std::uint32_t>(first_.boxes.size());
        origins.reserve(2 * std::size_t{count});
        first_.for_each_box(0, count, [&](std::uint32_t box, std::uint32_t block) {
            append_origin(first_.boxes[box], block, origins);
        });
        boxes_.put(first_.boxes, origins);
    }

    // The block of a box, and the least radius under it in the form of portable/kernels.h.
    void append_origin(const Box& box, std::uint32_t block,
                       std::vector<std::uint32_t>& origins) const {
        const std::uint32_t even_radius = first_.blocks[block].even_radius;
        std::uint32_t radius = even_radius | IS_EVEN;
        if (even_radius == 0) {
            const Under under = round_.plan.field().radius_field->under(box);
            const bool is_even = under.is_even && under.least != 0;
            radius = is_even ? under.greatest | IS_EVEN : under.least;
        }
        origins.insert(origins.end(), {block, radius});
    }

    void find_disk_areas() {
        double all = 0, sum = 0;
        for (std::uint32_t i = 0; i < first_.block_count(); ++i) {
            const FirstBoxes::Node& node = first_.nodes[first_.blocks[i].node];
            const double area =
                static_cast<double>(node.box.width) * (node.box.end - node.box.begin);
            const ClassCopies& copies = round_.plan.field().copies;
            const double side =
                2.0 * portable::times_factor(node.greatest,
                                             copies.greatest_factor(copies.of(node.box.x)));
            const double disk_area =
                std::min(side / round_.plan.width, 1.0) * std::min(side / round_.plan.height, 1.0);
            all += area;
            sum += area * disk_area;
            widest_disk_area_ = std::max(widest_disk_area_, disk_area);
        }
        mean_disk_area_ = sum / all;
    }

    const FirstBoxes& first_;
    ListBoxes boxes_;
    NeighbourLists lists_;
    // The fraction of the domain that a candidate's disk covers: on average, and at most.
    double mean_disk_area_ = 0;
    double widest_disk_area_ = 0;
};

}  // namespace

std::unique_ptr<Bins> make_field_boxes(RoundMemory& round) {
    return std::make_unique<FieldBoxes>(round);
}

}  // namespace lacuna::device
