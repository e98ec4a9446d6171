// The backend of every device: queues verbs, and repeats them until all draws are decided and fit.
#include "backends/device/device_backend.h"

#include <bit>
#include <cstdint>
#include <functional>
#include <stdexcept>
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
        for_parts([&](std::uint32_t) {
            bins_->locate(round_.draws_of_part());
            bins_->sort();
        });
        queue_->wait();
        stage_ = Stage::located;
    }

    // Part by part: each part's samples are taken out of the bins before the next part.
    void admit() override {
        expect(stage_ == Stage::located);
        if (round_.plan.is_exact()) bins_->screen({0, round_.draw_count}, STATUS_COVERED);
        std::vector<bool> is_done(round_.parts(), false);
        for (std::uint32_t part = 0; part < round_.parts(); ++part) {
            if (is_done[part]) continue;
            if (part > 0) end_part([&] { bins_->take_out(); });
            if (round_.parts() > 1) open_part(part);
            if (part > 0) screen_again(part, is_done);
            if (!is_done[part]) queue_passes();
        }
        queue_->wait();
        stage_ = Stage::admitted;
    }

    void subtract() override {
        if (stage_ == Stage::located || !bins_->is_cut_by_take_out())
            end_earlier_parts([&] { bins_->subtract(); });
        end_round(Stage::subtracted);
    }

    void refine(bool halve) override {
        if (stage_ == Stage::located) end_earlier_parts([&] { bins_->take_out(); });
        end_round(halve ? Stage::halved : Stage::refined);
    }

    Round finish_round() override {
        finish();
        const std::uint64_t survivors = take_admitted(round_.by_order, samples_);
        if (round_.plan.tells_orders) find_orders();
        return {samples_,        survivors, bins_->free_lengths(), bins_->width(),
                bins_->widths(), orders_,   bins_->begins(),       bins_->sheet_ends()};
    }
    std::vector<Candidate> located() override {
        settle(false);
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
        std::vector<Candidate> candidates =
            round_.restored_candidates(snapshot, bins_->part_limits(count));
        bins_->put_candidates(candidates);
        for_parts([&](std::uint32_t) { bins_->sort(); });  // also makes the buckets
        round_.restore_statuses(snapshot);
        stage_ = Stage::located;
    }

private:
    // The verbs of a round that are queued, which decide the verbs that may follow.
    enum class Stage {
        none,        // nothing: locate and restore begin a round
        located,     // candidates: admit, or the verb that ends the round if restore decided them
        admitted,    // passes over all parts; the samples of all but the last are taken out
        subtracted,  // one of three verbs that end the round: finish_round
        refined,
        halved,
    };

    static void expect(bool may_follow) {
        if (!may_follow) throw std::logic_error("this verb may not follow what is queued");
    }

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

    void open_part(std::uint32_t part) {
        if (round_.parts() > 1) queue_->wait();
        round_.open_part(part);
        bins_->begin_part();
    }

    template <typename Work>
    void for_parts(Work work) {
        for (std::uint32_t part = 0; part < round_.parts(); ++part) {
            open_part(part);
            work(part);
        }
    }

    // Ends the open part. On the device, what queue_end queues does nothing until the part's draws
    // are decided.
    template <typename QueueEnd>
    void end_part(QueueEnd queue_end) {
        queue_end();
        settle(false, queue_end);
    }

    // Ends all parts but the last, which stays open.
    template <typename QueueEnd>
    void end_earlier_parts(QueueEnd queue_end) {
        if (round_.parts() == 1) return;
        settle(false);
        for_parts([&](std::uint32_t part) {
            if (part + 1 < round_.parts()) end_part(queue_end);
        });
    }

    void end_round(Stage stage) {
        expect(stage_ == Stage::located || stage_ == Stage::admitted);
        stage_ = stage;
        queue_end_of_round();
        queue_->wait();
    }

    // Does nothing on the device while a draw is undecided.
    void queue_end_of_round() {
        if (stage_ == Stage::subtracted) bins_->subtract();
        if (stage_ == Stage::refined || stage_ == Stage::halved)
            bins_->refine(stage_ == Stage::halved);
    }

    // Screens the open part and, if its number is a power of 2, all later parts too: after the
    // first few parts, most later ones have no undecided draw and are done.
    void screen_again(std::uint32_t part, std::vector<bool>& is_done) {
        const bool is_for_all = std::has_single_bit(part);
        bins_->screen({round_.part.begin, is_for_all ? round_.draw_count : round_.part.end},
                      STATUS_REJECTED);
        if (is_for_all) round_.find_done(part, is_done);
    }

    void queue_passes() {
        for (std::uint32_t pass = 0; pass < kPasses; ++pass) bins_->admit(pass);
    }

    // Completes the round.
    void finish() {
        if (stage_ == Stage::none) return;
        settle(true);
        bins_->end_round();
        stage_ = Stage::none;
    }

    // Waits, and queues what the round still needs: passes, cuts with more room, samples left over.
    void settle(bool with_samples) {
        settle(with_samples, [&] { queue_end_of_round(); });
    }
    template <typename QueueEnd>
    void settle(bool with_samples, QueueEnd queue_end) {
        while (true) {
            round_.start_download(with_samples);
            bins_->start_download();
            queue_->wait();
            round_.throw_if_failed();
            if (round_.is_unsettled()) {
                round_.begin_more_passes();
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
    Stage stage_ = Stage::none;
};

}  // namespace

std::unique_ptr<Backend> make_backend(std::unique_ptr<Queue> queue, const Plan& plan,
                                      const Tuning& tuning) {
    const DeviceEntry& device = queue->device();
    refuse_if_too_large(device.name, plan, device.memory_bytes, device.largest_buffer_bytes);
    return std::make_unique<DeviceBackend>(std::move(queue), plan, tuning);
}

}  // namespace lacuna::device
