// The backend of every device: queues verbs, and repeats them until all draws are decided and fit.
#include "backends/device/device_backend.h"

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/device/bins.h"
#include "backends/device/round_memory.h"
#include "portable/status.h"
#include "space/portion.h"

namespace lacuna::device {
namespace {

class DeviceBackend : public Backend {
public:
    DeviceBackend(std::unique_ptr<Queue> queue, const Plan& plan, std::uint32_t threads,
                  const Tuning& tuning)
        : queue_(std::move(queue)),
          workers_(threads),
          round_(plan, *queue_),
          bins_(make_bins(tuning)) {}

    // Transfers into this object's memory may still be under way when an error ends a run.
    ~DeviceBackend() override { queue_->drain(); }
    DeviceBackend(const DeviceBackend&) = delete;
    DeviceBackend& operator=(const DeviceBackend&) = delete;

    std::string device() const override { return queue_->device().name; }
    Work work() const override { return queue_->work(); }
    Workers& workers() override { return workers_; }
    void time_verbs() override {
        times_verbs_ = true;
        queue_->time_kernels();
    }
    void watch(std::function<bool()> may_go_on) override {
        workers_.watch(may_go_on);
        queue_->watch(std::move(may_go_on));
    }

    std::span<Draw> room_for_draws(std::size_t count) override {
        if (draws_.bytes() < count * sizeof(Draw)) {
            draws_ = {};  // frees the old memory first
            draws_ = queue_->host_memory(count * sizeof(Draw));
        }
        return draws_.values<Draw>(count);
    }

    void locate(std::span<const Draw> draws) override {
        finish();
        const auto count = static_cast<std::uint32_t>(draws.size());
        round_.upload(draws, bins_->sorted_columns(), bins_->part_limits(count));
        bins_->begin_round();
        for_parts([&](std::uint32_t) {
            bins_->locate(round_.draws_of_part());
            bins_->sort();
        });
        wait_for_verb();
        stage_ = Stage::located;
    }

    // Part by part: each part's samples are taken out of the bins before the next part.
    void admit() override {
        expect(stage_ == Stage::located);
        const bool is_one = round_.parts() == 1;
        bins_->screen({0, round_.draw_count},
                      round_.plan.is_exact() ? STATUS_COVERED : STATUS_UNDECIDED, is_one);
        std::vector<bool> is_done(round_.parts(), false);
        for (std::uint32_t part = 0; part < round_.parts(); ++part) {
            if (is_done[part]) continue;
            if (part > 0) end_part([&] { bins_->take_out(); });
            if (!is_one) open_part(part);
            if (!is_one) screen_again(part, is_done);
            if (!is_done[part]) queue_passes();
        }
        wait_for_verb();
        stage_ = Stage::admitted;
    }

    void subtract() override { end_round(Stage::subtracted); }

    void refine(bool halve) override { end_round(halve ? Stage::halved : Stage::refined); }

    Round finish_round() override {
        finish();
        if (round_.plan.tells_orders) round_.find_orders(orders_);
        return {round_.plan.is_space() ? std::span<const Sample>() : round_.samples<Sample>(),
                round_.survivors(),
                bins_->free_lengths(),
                bins_->width(),
                bins_->widths(),
                orders_,
                bins_->begins(),
                bins_->copy_ends()};
    }
    // In space samples come from here, not from finish_round(). They are valid as long as its
    // results.
    using SpaceWords = std::array<std::uint32_t, 3>;
    std::span<const SpaceWords> samples_in_space() const { return round_.samples<SpaceWords>(); }

    std::vector<Candidate> located() override {
        settle();
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
        bins_->begin_round();
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
        if (round_.plan.is_space()) return make_portions(round_);
        if (round_.plan.has_radius_field()) return make_field_boxes(round_);
        return round_.plan.is_cells() ? make_lattice(round_, tuning) : make_spans(round_, tuning);
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

    // Ends the open part. On the device, what queue_end queues does nothing until the part's
    // draws are decided.
    template <typename QueueEnd>
    void end_part(QueueEnd queue_end) {
        queue_end();
        settle(queue_end);
    }

    // Ends all parts but the last, which stays open.
    void end_earlier_parts() {
        if (round_.parts() == 1) return;
        settle();
        for_parts([&](std::uint32_t part) {
            if (part + 1 < round_.parts()) end_part([&] { bins_->take_out(); });
        });
    }

    void end_round(Stage stage) {
        expect(stage_ == Stage::located || stage_ == Stage::admitted);
        if (stage_ == Stage::located) end_earlier_parts();
        stage_ = stage;
        queue_end_of_round();
        wait_for_verb();
    }

    bool has_ended() const { return stage_ > Stage::admitted; }

    // Does nothing on the device while a draw is undecided.
    void queue_end_of_round() {
        if (stage_ == Stage::subtracted) bins_->subtract();
        if (stage_ == Stage::refined || stage_ == Stage::halved)
            bins_->refine(stage_ == Stage::halved);
    }

    // Screens the open part. If its number is a power of 2, screens all later parts first:
    // after the first few parts, most later ones have no undecided draw and are done.
    void screen_again(std::uint32_t part, std::vector<bool>& is_done) {
        if (std::has_single_bit(part)) {
            bins_->screen({round_.part.begin, round_.draw_count}, STATUS_REJECTED, false);
            round_.find_done(part, is_done);
        }
        if (!is_done[part])
            bins_->screen(round_.part, part == 0 ? STATUS_UNDECIDED : STATUS_REJECTED, true);
    }

    void queue_passes() {
        for (std::uint32_t pass = 0; pass < kPasses; ++pass) bins_->admit(pass);
    }

    // Completes the round. A round that tests end after admit has samples only.
    void finish() {
        if (stage_ == Stage::none) return;
        settle();
        if (has_ended()) {
            bins_->download();
        } else {
            round_.make_room_for_listing({});
            round_.count_samples({});
            round_.list_samples({});
            settle();
            round_.download_results(0);
        }
        queue_->wait();
        if (has_ended()) bins_->end_round();
        stage_ = Stage::none;
    }

    // Waits, and queues what the round still needs: passes, cuts with more room, samples left over.
    void settle() {
        settle([&] { queue_end_of_round(); });
    }
    template <typename QueueEnd>
    void settle(QueueEnd queue_end) {
        while (true) {
            round_.start_download();
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

    // So that an observer can tell the verbs' times apart.
    void wait_for_verb() {
        if (times_verbs_) queue_->wait();
    }

    std::unique_ptr<Queue> queue_;
    Workers workers_;
    RoundMemory round_;
    std::unique_ptr<Bins> bins_;
    HostMemory draws_;
    std::vector<std::uint32_t> orders_;  // with plan.tells_orders
    bool times_verbs_ = false;
    Stage stage_ = Stage::none;
};

// The backend in space: bins and samples have three coordinates.
class DeviceInSpace : public space::SpaceBackend {
public:
    DeviceInSpace(std::unique_ptr<Queue> queue, const Plan& plan, std::uint32_t threads)
        : all_(*plan.space().first_bins), backend_(std::move(queue), plan, threads, {}) {}

    std::string device() const override { return backend_.device(); }
    Work work() const override { return backend_.work(); }
    Workers& workers() override { return backend_.workers(); }
    void time_verbs() override { backend_.time_verbs(); }
    void watch(std::function<bool()> may_go_on) override { backend_.watch(std::move(may_go_on)); }
    std::span<Draw> room_for_draws(std::size_t count) override {
        return backend_.room_for_draws(count);
    }
    void locate(std::span<const Draw> draws) override { backend_.locate(draws); }
    void admit() override { backend_.admit(); }
    void subtract() override { backend_.subtract(); }
    void refine(bool halve) override { backend_.refine(halve); }
    RoundOf<space::SpaceSample> finish_round() override {
        const Round round = backend_.finish_round();
        samples_.clear();
        for (const auto& [first, second, third] : backend_.samples_in_space())
            samples_.push_back(space::sample_of_words(all_, first, second, third));
        return {.samples = samples_,
                .survivors = round.survivors,
                .free_lengths = round.free_lengths,
                .bin_width = round.bin_width,
                .bin_widths = round.bin_widths};
    }

private:
    const space::FirstBins& all_;
    DeviceBackend backend_;
    std::vector<space::SpaceSample> samples_;  // of the round
};

std::unique_ptr<Queue> checked(std::unique_ptr<Queue> queue, const Plan& plan) {
    const DeviceEntry& device = queue->device();
    refuse_if_too_large(device.name, plan, device.memory_bytes, device.largest_buffer_bytes);
    return queue;
}

}  // namespace

std::unique_ptr<Backend> make_backend(std::unique_ptr<Queue> queue, const Plan& plan,
                                      std::uint32_t threads, const Tuning& tuning) {
    return std::make_unique<DeviceBackend>(checked(std::move(queue), plan), plan, threads, tuning);
}

std::unique_ptr<space::SpaceBackend> make_space_backend(std::unique_ptr<Queue> queue,
                                                        const Plan& plan, std::uint32_t threads) {
    return std::make_unique<DeviceInSpace>(checked(std::move(queue), plan), plan, threads);
}

}  // namespace lacuna::device
