// The bins of mode exact with a radius field on a device: active boxes, which the samples in
// neighbour lists cut (docs/design.md, section 4).
#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "backends/device/bins.h"
#include "backends/device/boxes.h"
#include "backends/device/field_tables.h"
#include "backends/device/neighbour_lists.h"
#include "plan/first_boxes.h"
#include "plan/radius_field.h"
#include "portable/radius_field.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

// The work of a draw, see Queue::launch.
constexpr std::uint64_t kFieldLocateWork = 2;
constexpr std::uint64_t kListScreenWork = 2;

class FieldBoxes : public Bins {
public:
    explicit FieldBoxes(RoundMemory& round)
        : Bins(round), first_(*round.plan.field().first_boxes), boxes_(round), lists_(round) {
        make_tables();
        put_first_boxes();
        find_disk_areas();
        lists_.enlist_kept();
    }

    std::span<const std::uint32_t> begins() const override { return boxes_.begins(); }

    PartLimits part_limits(std::uint32_t count) const override {
        PartLimits limits = limits_by_area(count, mean_disk_area_, widest_disk_area_);
        limits.of_column = limits.most;  // nothing is sorted
        return limits;
    }

    void begin_part() override {
        round_.make_room(round_.memory.candidate_radii, round_.draw_count);
        lists_.begin_part();
    }

    void locate(std::span<const Draw>) override {
        round_.launch_over_draws<kernels::locate_with_field>(round_.arguments(), kFieldLocateWork);
    }
    void sort() override {}

    // Serves all parts at once: no sample of the round is in a list yet.
    void screen() override {
        portable::DrawArguments arguments = round_.arguments();
        arguments.status = STATUS_COVERED;
        arguments.first = 0;
        arguments.count = round_.draw_count;
        arguments.is_listed = lists_.has_survivors() ? 1 : 0;
        lists_.begin_survivors();
        round_.launch_over_draws<kernels::screen_with_field>(arguments, kListScreenWork);
    }
    void screen_again(std::uint32_t end) override {
        portable::DrawArguments arguments = round_.arguments();
        arguments.status = STATUS_REJECTED;
        arguments.count = end;
        round_.launch_over_draws<kernels::screen_with_field>(arguments, kListScreenWork);
    }

    void admit(std::uint32_t pass) override {
        if (!lists_.has_visitors()) lists_.list_visitors();
        portable::DrawArguments arguments = round_.arguments();
        arguments.pass = pass;
        arguments.chunk = round_.chunk_of_admit(round_.queue.run_of(round_.part_count()));
        round_.launch_over_draws<kernels::admit_with_field>(arguments,
                                                            RoundMemory::admit_work(pass));
    }

    void subtract() override { throw std::logic_error("with a radius field every round refines"); }
    void take_out() override { lists_.enlist(); }

    // Halves are cut by all samples in their lists; boxes that are not halved only by the round's.
    void refine(bool halve) override {
        take_out();
        is_refining_ = true;
        boxes_.refine(halve, halve ? 0 : lists_.first_recent());
    }

    void start_download() override {
        lists_.start_download();
        boxes_.start_download();
    }
    bool queue_rest() override { return boxes_.queue_rest(); }
    void end_round() override {
        boxes_.end_round();
        if (is_refining_) lists_.end_round();
        is_refining_ = false;
    }

    std::span<const std::uint32_t> free_lengths() const override { return boxes_.free_lengths(); }
    std::uint32_t width() const override { return round_.plan.strip_width; }
    std::span<const std::uint32_t> widths() const override { return boxes_.widths(); }

    void snapshot(Snapshot&) override { throw std::logic_error("no test looks into a field"); }
    void restore(const Snapshot&) override { throw std::logic_error("no test restores a field"); }

private:
    void make_tables() {
        const FieldTables tables = tables_of(*round_.plan.field().radius_field);
        Memory& m = round_.memory;
        m.axes = round_.copy_of(tables.axes);
        m.mask_bits = round_.copy_of(tables.mask_bits);
        using Radii = RadiusField::Radii;
        static_assert(sizeof(Radii) == 2 * kWord);
        const RadiusField::RadiusPyramid& radii = round_.plan.field().radius_field->radii();
        std::uint64_t count = 0;
        radii.for_each_level([&](std::span<const Radii> level) { count += level.size(); });
        round_.make_room(m.radius_bounds, 2 * count);
        std::uint64_t first = 0;
        radii.for_each_level([&](std::span<const Radii> level) {
            round_.put(m.radius_bounds, level, 2 * first);
            first += level.size();
        });
        round_.queue.wait();
    }

    void put_first_boxes() {
        std::vector<std::uint32_t> origins;
        const auto count = static_cast<std::uint32_t>(first_.boxes.size());
        origins.reserve(2 * std::size_t{count});
        first_.for_each_box(0, count, [&](std::uint32_t box, std::uint32_t block) {
            origins.insert(origins.end(), {block, first_radius(box, block)});
        });
        boxes_.put(first_.boxes, origins, 0);
    }

    // The least radius under a first box, in the form of portable/kernels.h.
    std::uint32_t first_radius(std::uint32_t box, std::uint32_t block) const {
        const std::uint32_t even_radius = first_.blocks[block].even_radius;
        if (even_radius != 0) return even_radius | IS_EVEN;
        const Under under = round_.plan.field().radius_field->under(first_.boxes[box]);
        return under.least | (under.is_even ? IS_EVEN : 0);
    }

    void find_disk_areas() {
        double all = 0, sum = 0;
        for (std::uint32_t i = 0; i < first_.block_count(); ++i) {
            const FirstBoxes::Node& node = first_.nodes[first_.blocks[i].node];
            const double area =
                static_cast<double>(node.box.width) * (node.box.end - node.box.begin);
            const double side = 2.0 * node.greatest;
            const double disk_area =
                std::min(side / round_.plan.width, 1.0) * std::min(side / round_.plan.height, 1.0);
            all += area;
            sum += area * disk_area;
            widest_disk_area_ = std::max(widest_disk_area_, disk_area);
        }
        mean_disk_area_ = sum / all;
    }

    const FirstBoxes& first_;
    Boxes boxes_;
    NeighbourLists lists_;
    bool is_refining_ = false;  // until end_round
    // The fraction of the domain that a candidate's disk covers: on average, and at most.
    double mean_disk_area_ = 0;
    double widest_disk_area_ = 0;
};

}  // namespace

std::unique_ptr<Bins> make_field_boxes(RoundMemory& round) {
    return std::make_unique<FieldBoxes>(round);
}

}  // namespace lacuna::device
