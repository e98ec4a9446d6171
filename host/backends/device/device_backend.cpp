// The backend of every device: queues verbs, and repeats them until all draws are decided and fit.
#include "backends/device/device_backend.h"

#include <bit>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "backends/device/bins.h"
#include "backends/device/round_memory.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

class DeviceBackend : public Backend {
public:
    DeviceBackend(std::unique_ptr<Queue> queue, const Plan& plan, const Tuning& tuning)
        : queue_(std::move(queue)), round_(plan, *queue_), bins_(make_bins(tuning)) {}

    // Transfers into this object's memory may still be under way when an error ends a run.
    ~DeviceBackend() override { queue_->drain(); }
    DeviceBackend(const DeviceBackend&) = delete;
    DeviceBackend& operator=(const DeviceBackend&) = delete;

    std::string device() const override { return queue_->device().name; }
    Workers& workers() override { return workers_; }
    void watch(std::function<bool()> may_go_on) override {
        workers_.watch(may_go_on);
        queue_->watch(std::move(may_go_on));
    }

    // Each verb waits, so that an observer can tell their times apart.
    void locate(std::span<const Draw> draws) override {
        finish();
        const auto count = static_cast<std::uint32_t>(draws.size());
        round_.upload(draws, bins_->begins(), bins_->part_limits(count));
        for_parts([&] {
            bins_->locate(round_.draws_of_part());
            bins_->sort();
        });
        ends_with_ = End::none;
        has_statuses_ = are_out_ = false;
        settle_later();
    }

    // Part by part: each part's samples are taken out of the bins before the next part.
    void admit() override {
        bins_->screen();
        const bool had_statuses = has_statuses_;
        std::vector<bool> is_done(round_.parts(), false);
        for (std::uint32_t part = 0; part < round_.parts(); ++part) {
            if (is_done[part]) continue;
            if (part > 0) take_out();
            if (round_.parts() > 1) open_part(part);
            if (part > 0) screen_again(part, is_done);
            if (is_done[part]) continue;
            has_statuses_ = had_statuses;
            queue_passes();
        }
        are_out_ = true;
        settle_later();
    }

    void subtract() override {
        if (!are_out_ || !bins_->is_cut_by_take_out()) end_parts(End::subtract);
        ends_with_ = End::subtract;
        queue_end();
        settle_later();
    }

    void refine(bool halve) override {
        if (!are_out_) end_parts(End::take_out);
        if (bins_->queue_before_refine()) {
            is_open_ = true;
            finish();
        }
        ends_with_ = End::refine;
        halves_ = halve;
        queue_end();
        settle_later();
    }

    Round finish_round() override {
        is_open_ = true;
        finish();
        const std::uint64_t survivors = take_admitted(round_.by_order, samples_);
        if (round_.plan.tells_orders) find_orders();
        return {samples_,        survivors, bins_->free_lengths(), bins_->width(),
                bins_->widths(), orders_,   bins_->begins()};
    }
    std::vector<Candidate> located() override {
        finish();
        return round_.candidates();
    }

    Snapshot snapshot() override {
        finish();
        Snapshot snapshot;
        round_.snapshot(snapshot);
        bins_->snapshot(snapshot);
        return snapshot;
    }

    void restore(const Snapshot& snapshot) override {
        finish();
        bins_->restore(snapshot);
        const auto count = static_cast<std::uint32_t>(snapshot.candidates.size());
        round_.restore_candidates(snapshot, bins_->part_limits(count));
        for_parts([&] { bins_->sort(); });  // which makes the buckets
        round_.restore_statuses(snapshot);
        ends_with_ = End::none;
        has_statuses_ = true;
        are_out_ = false;
    }

private:
    std::unique_ptr<Bins> make_bins(const Tuning& tuning) {
        if (round_.plan.has_field()) return make_field_boxes(round_);
        return round_.plan.is_cells() ? make_lattice(round_, tuning) : make_spans(round_, tuning);
    }

    // Lists the orders of the samples' draws.
    void find_orders() {
        orders_.clear();
        for (std::uint32_t order = 0; order < round_.by_order.size(); ++order)
            if (round_.by_order[order].x != NO_SAMPLE) orders_.push_back(order);
    }

    enum class End { none, take_out, subtract, refine };  // how a part or the round ends

    void open_part(std::uint32_t part) {
        if (round_.parts() > 1) queue_->wait();
        round_.open_part(part);
        bins_->begin_part();
    }

    template <typename Work>
    void for_parts(Work work) {
        for (std::uint32_t part = 0; part < round_.parts(); ++part) {
            open_part(part);
            work();
        }
    }

    // Ends the open part, after its draws are decided.
    void end_part(End with) {
        ends_with_ = with;
        queue_end();
        settle(false);
        ends_with_ = End::none;
    }
    void take_out() { end_part(End::take_out); }
    // If there are several parts, ends all. Ending the last one once more then does nothing.
    void end_parts(End with) {
        if (round_.parts() == 1) return;
        if (is_open_) settle(false);
        for_parts([&] { end_part(with); });
    }

    // Screens the open part, and now and then all later parts too: after the first few, most have
    // no undecided draw and are done.
    void screen_again(std::uint32_t part, std::vector<bool>& is_done) {
        if (!std::has_single_bit(part)) return bins_->screen_again(round_.part.end);
        bins_->screen_again(round_.draw_count);
        round_.find_done(part, is_done);
    }

    // Passes after the first kPasses go on with the draws still undecided.
    void queue_passes() {
        if (has_statuses_) round_.begin_more_passes();
        for (std::uint32_t pass = has_statuses_ ? 1 : 0; pass < kPasses; ++pass) bins_->admit(pass);
        has_statuses_ = true;
    }

    // On the device this does nothing while a draw is undecided.
    void queue_end() {
        if (ends_with_ == End::take_out) bins_->take_out();
        if (ends_with_ == End::subtract) bins_->subtract();
        if (ends_with_ == End::refine) bins_->refine(halves_);
    }

    // The result of the queued work must be checked at the end of the round.
    void settle_later() {
        is_open_ = true;
        queue_->wait();
    }

    // Waits for the verbs, and queues what they still need: passes, room, samples left over.
    void finish() {
        if (!is_open_) return;
        settle(true);
        bins_->end_round();
        is_open_ = false;
        ends_with_ = End::none;
    }

    void settle(bool with_samples) {
        while (true) {
            round_.start_download(with_samples);
            bins_->start_download();
            queue_->wait();
            round_.throw_if_failed();
            if (round_.is_unsettled()) {
                queue_passes();
                queue_end();
            } else if (!bins_->queue_rest()) {
                return;
            }
        }
    }

    std::unique_ptr<Queue> queue_;
    Workers workers_{0};
    RoundMemory round_;
    std::unique_ptr<Bins> bins_;
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> orders_;  // with plan.tells_orders
    bool is_open_ = false;               // some verb's result is unchecked
    bool has_statuses_ = false;          // some passes have been made
    bool are_out_ = false;               // samples of all parts except the open one
    End ends_with_ = End::none;
    bool halves_ = false;
};

}  // namespace

std::unique_ptr<Backend> make_backend(std::unique_ptr<Queue> queue, const Plan& plan,
                                      const Tuning& tuning) {
    const DeviceEntry& device = queue->device();
    refuse_if_too_large(device.name, plan, device.memory_bytes, device.largest_buffer_bytes);
    return std::make_unique<DeviceBackend>(std::move(queue), plan, tuning);
}

}  // namespace lacuna::device
