// The places of mode exact with a radius field: rectangles, which lists of the samples that reach
// their blocks cut (docs/design.md, section 4, "exact with a field").
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/device/field_tables.h"
#include "backends/device/places.h"
#include "backends/device/sample_lists.h"
#include "backends/device/scan.h"
#include "plan/first_boxes.h"
#include "plan/radius_field.h"
#include "portable/radius_field.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

// See Queue::launch.
constexpr std::uint64_t kFieldLocateWork = 2;
constexpr std::uint64_t kFieldScreenWork = 2;
constexpr std::uint64_t kFieldCutWork = 4;
constexpr std::uint64_t kFieldSeveralWork = 16;
constexpr std::uint64_t kFieldKeepWork = 1;
constexpr std::uint64_t kFieldSplitWork = 8;
constexpr std::uint64_t kFieldMeasureWork = 2;

// Of so many places those of which several pieces may be left, or those that lie on unlike pixels,
// are for one item: seldom more than a few.
constexpr std::uint32_t kPlacesPerSeveral = 16;
constexpr std::uint32_t kPlacesPerUneven = 8;

// Pieces beyond what is expected; there are seldom as many.
constexpr std::uint32_t kSparePlaces = 1024;

constexpr std::uint32_t kLists = 2;  // new_uneven and several, see portable/radius_field.h

static_assert(sizeof(Rectangle) == 4 * kWord);

class Rectangles : public Places {
public:
    explicit Rectangles(RoundMemory& round)
        : Places(round), first_(*round.plan.first_boxes), lists_(round) {
        make_tables();
        take_first_boxes();
        put_first_boxes();
        find_shares();
        lists_.enlist_kept();
    }

    std::span<const std::uint32_t> begins() const override { return begins_; }

    PartLimits part_limits(std::uint32_t count) const override {
        PartLimits limits = limits_by_share(count, mean_share_, widest_share_);
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

    // Of all parts: no sample of the round is in a list yet.
    void screen() override {
        portable::DrawArguments arguments = round_.arguments(STATUS_COVERED);
        arguments.first = 0;
        arguments.count = round_.draw_count;
        arguments.is_listed = lists_.has_survivors() ? 1 : 0;
        lists_.begin_survivors();
        round_.launch_over_draws<kernels::screen_with_field>(arguments, kFieldScreenWork);
    }
    void screen_again(std::uint32_t end) override {
        portable::DrawArguments arguments = round_.arguments(STATUS_REJECTED);
        arguments.count = end;
        round_.launch_over_draws<kernels::screen_with_field>(arguments, kFieldScreenWork);
    }

    void admit(std::uint32_t pass) override {
        if (!lists_.has_visitors()) lists_.list_visitors();
        portable::DrawArguments arguments = round_.arguments(pass);
        arguments.chunk = round_.chunk_of_admit(round_.queue.run_of(round_.part_count()));
        round_.launch_over_draws<kernels::admit_with_field>(arguments,
                                                            RoundMemory::admit_work(pass));
    }

    void subtract() override { throw std::logic_error("a radius field is refined from the start"); }

    void take_out() override { lists_.enlist(); }

    void refine(bool halve) override {
        take_out();
        is_refining_ = true;
        is_halving_ = halve;
        new_room_ = expected_places();
        Memory& m = round_.memory;
        const std::uint64_t strips = halve ? 4 * std::uint64_t{uneven_} : 0;
        round_.make_room(m.strips, 4 * strips);
        round_.make_room(m.strip_radii, strips);
        make_room_for_places(m.pieces, 4, count_);
        make_room_for_places(m.more_pieces, 4, halve ? count_ : 0);
        make_room_for_places(m.several, 2, count_);
        round_.queue.fill(m.list_counts, 0, kLists);
        make_room_for_places(m.counts, 1, count_);
        make_room_to_scan(round_, count_);
        cut();
        scan(round_, count_);
        keep();
    }

    void start_download() override {
        lists_.start_download();
        if (!is_refining_) return;
        round_.get<std::uint32_t>(round_.memory.total, total_);
        round_.get<std::uint32_t>(round_.memory.list_counts, list_counts_);
    }

    bool queue_rest() override {
        if (!is_refining_ || total_.front() <= new_room_) return false;
        new_room_ = total_.front();
        static_assert(OF_NEW_UNEVEN == 0);  // the word that is filled
        round_.queue.fill(round_.memory.list_counts, 0, 1);
        keep();
        return true;
    }

    void end_round() override {
        if (!is_refining_) return;
        is_refining_ = false;
        Memory& m = round_.memory;
        std::swap(m.places, m.new_places);
        std::swap(m.origins, m.new_origins);
        std::swap(m.uneven, m.new_uneven);
        take_count(total_.front());
        round_.get<std::uint32_t>(m.widths, widths_);
        round_.get<std::uint32_t>(m.free_lengths, lengths_);
        round_.queue.wait();
        uneven_ = list_counts_[OF_NEW_UNEVEN];
        lists_.end_round();
    }

    std::span<const std::uint32_t> free_lengths() const override { return lengths_; }
    std::uint32_t width() const override { return round_.plan.strip_width; }
    std::span<const std::uint32_t> widths() const override { return widths_; }

    void snapshot(Snapshot&) override {
        throw std::logic_error("no test looks into a radius field");
    }
    void restore(const Snapshot&) override {
        throw std::logic_error("no test restores a radius field");
    }

private:
    void make_tables() {
        const FieldTables tables = tables_of(*round_.plan.radius_field);
        Memory& m = round_.memory;
        m.axes = round_.copy_of(tables.axes);
        m.mask_bits = round_.copy_of(tables.mask_bits);
        put_radii();
        round_.queue.wait();
    }

    void put_radii() {
        using Radii = RadiusField::Radii;
        static_assert(sizeof(Radii) == 2 * kWord);
        const RadiusField::RadiusPyramid& radii = round_.plan.radius_field->radii();
        Buffer& to = round_.memory.radius_bounds;
        std::uint64_t count = 0;
        radii.for_each_level([&](std::span<const Radii> level) { count += level.size(); });
        round_.make_room(to, 2 * count);
        std::uint64_t first = 0;
        radii.for_each_level([&](std::span<const Radii> level) {
            round_.put(to, level, 2 * first);
            first += level.size();
        });
    }

    void take_first_boxes() {
        take_count(static_cast<std::uint32_t>(first_.places.size()));
        for (std::uint32_t i = 0; i < count_; ++i) {
            widths_[i] = first_.places[i].width;
            lengths_[i] = first_.places[i].end - first_.places[i].begin;
        }
    }

    void put_first_boxes() {
        std::vector<std::uint32_t> origins;
        std::vector<std::uint32_t> uneven;
        origins.reserve(2 * std::size_t{count_});
        first_.for_each_place(0, count_, [&](std::uint32_t place, std::uint32_t block) {
            const std::uint32_t radius = first_radius(place, block);
            origins.insert(origins.end(), {block, radius});
            if ((radius & IS_EVEN) == 0) uneven.push_back(place);
        });
        uneven_ = static_cast<std::uint32_t>(uneven.size());
        Memory& m = round_.memory;
        round_.put_in_room<Rectangle>(m.places, first_.places);
        round_.put_in_room<std::uint32_t>(m.origins, origins);
        round_.put_in_room<std::uint32_t>(m.uneven, uneven);
        round_.make_room(m.list_counts, kLists);
    }

    // The least one under a first place, as devices have it, see portable/kernels.h.
    std::uint32_t first_radius(std::uint32_t place, std::uint32_t block) const {
        const std::uint32_t even_radius = first_.blocks[block].even_radius;
        if (even_radius != 0) return even_radius | IS_EVEN;
        const Under under = round_.plan.radius_field->under(first_.places[place]);
        return under.least | (under.is_even ? IS_EVEN : 0);
    }

    void take_count(std::uint32_t places) {
        count_ = places;
        begins_ = {0, count_};
        widths_.resize(count_);
        lengths_.resize(count_);
    }

    // Of the domain, within the radius of a place: on average, and at most.
    void find_shares() {
        double all = 0, sum = 0;
        for (std::uint32_t i = 0; i < first_.block_count(); ++i) {
            const auto& [place, greatest, next, first, whole] = first_.nodes[first_.blocks[i].node];
            const double area = static_cast<double>(place.width) * (place.end - place.begin);
            const double side = 2.0 * greatest;
            const double share =
                std::min(side / round_.plan.width, 1.0) * std::min(side / round_.plan.height, 1.0);
            all += area;
            sum += area * share;
            widest_share_ = std::max(widest_share_, share);
        }
        mean_share_ = sum / all;
    }

    // At once for as many places as there will be, most likely: their number grows for some rounds,
    // and memory made anew is cleared page by page.
    void make_room_for_places(Buffer& buffer, std::uint64_t words, std::uint64_t places) const {
        const std::uint64_t most = std::max(places, room_for_places(round_.plan));
        round_.make_room(buffer, places == 0 ? 0 : words * most);
    }

    // Seldom more: the samples of a round cut few places in two. Of halves more than a quarter are
    // covered, but where places lie on unlike pixels.
    std::uint32_t expected_places() const {
        const std::uint32_t cut = is_halving_ ? count_ / 4 * 3 + uneven_ : count_ / 32;
        return count_ + cut + kSparePlaces;
    }

    // Serves so many places, or uneven ones. Halves are cut by all samples in their lists, and what
    // is not halved by those of the round.
    template <typename Kernel>
    void launch_over(std::uint32_t count, std::uint64_t work) {
        const portable::StripArguments arguments = this->arguments(count);
        launch<Kernel>(round_.queue, round_.memory, arguments, items_of(count, arguments.chunk),
                       work * arguments.chunk);
    }
    // Serves a list whose length the device knows, with so many items.
    template <typename Kernel>
    void launch_over_list(std::uint32_t items, std::uint64_t work) {
        portable::StripArguments arguments = this->arguments(count_);
        arguments.chunk = std::max(items, 1u);
        launch<Kernel>(round_.queue, round_.memory, arguments, arguments.chunk, work);
    }

    portable::StripArguments arguments(std::uint32_t count) const {
        return {0,
                round_.queue.chunk_of(count),
                round_.geometry,
                count,
                is_halving_ ? 1u : 0u,
                0,
                kPasses - 1,
                block_bits_of_scan(count_),
                new_room_,
                is_halving_ ? 0 : lists_.first_recent(),
                0,
                0};
    }

    void cut() {
        if (is_halving_) {
            launch_over<kernels::cut_halves>(count_, kFieldCutWork);
            launch_over<kernels::split>(uneven_, kFieldSplitWork);
            launch_over<kernels::cut_uneven>(uneven_, kFieldCutWork);
        } else {
            launch_over<kernels::cut_places>(count_, kFieldCutWork);
        }
        launch_over_list<kernels::cut_several>(count_ / kPlacesPerSeveral, kFieldSeveralWork);
    }

    void keep() {
        Memory& m = round_.memory;
        make_room_for_places(m.new_places, 4, new_room_);
        make_room_for_places(m.new_origins, 2, new_room_);
        make_room_for_places(m.widths, 1, new_room_);
        make_room_for_places(m.free_lengths, 1, new_room_);
        make_room_for_places(m.new_uneven, 1, new_room_);
        if (is_halving_) {
            launch_over<kernels::keep_halves>(count_, kFieldKeepWork);
            launch_over<kernels::keep_uneven>(uneven_, kFieldKeepWork);
        } else {
            launch_over<kernels::keep_places>(count_, kFieldKeepWork);
        }
        launch_over_list<kernels::keep_several>(count_ / kPlacesPerSeveral, kFieldSeveralWork);
        launch_over_list<kernels::measure>(new_room_ / kPlacesPerUneven, kFieldMeasureWork);
    }

    const FirstBoxes& first_;
    SampleLists lists_;
    std::array<std::uint32_t, 2> begins_{};  // all places are one column: nothing is sorted
    std::uint32_t count_ = 0;                // of places
    std::uint32_t uneven_ = 0;               // of those that lie on unlike pixels, perhaps
    std::vector<std::uint32_t> lengths_;
    std::vector<std::uint32_t> widths_;
    double mean_share_ = 0;
    double widest_share_ = 0;

    // Of a refinement under way.
    bool is_refining_ = false;
    bool is_halving_ = false;
    std::uint32_t new_room_ = 0;
    std::array<std::uint32_t, 1> total_{};
    std::array<std::uint32_t, kLists> list_counts_{};
};

}  // namespace

std::unique_ptr<Places> make_rectangles(RoundMemory& round) {
    return std::make_unique<Rectangles>(round);
}

}  // namespace lacuna::device
