// The backend of every device: the settle-grow-retry loop over a queue.
#include "backends/device/device_backend.h"

#include <functional>
#include <utility>
#include <vector>

#include "backends/device/places.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {
namespace {

class DeviceBackend : public Backend {
public:
    DeviceBackend(std::unique_ptr<Queue> queue, const Plan& plan, const Tuning& tuning)
        : queue_(std::move(queue)),
          round_(plan, *queue_),
          places_(plan.mode == Mode::cells ? make_lattice(round_, tuning)
                                           : make_spans(round_, tuning)) {}

    // Transfers into this object's memory may be on their way when an error ends a run.
    ~DeviceBackend() override { queue_->drain(); }
    DeviceBackend(const DeviceBackend&) = delete;
    DeviceBackend& operator=(const DeviceBackend&) = delete;

    std::string device() const override { return queue_->device().name; }
    void watch(std::function<bool()> may_go_on) override { queue_->watch(std::move(may_go_on)); }

    // Each verb waits, so that an observer can tell their times apart.
    void locate(std::span<const Draw> draws) override {
        finish();
        round_.upload(draws, places_->begins());
        places_->begin_round();
        places_->locate(draws);
        sort();
        ends_with_ = End::none;
        has_fates_ = false;
        settle_later();
    }

    void admit() override {
        places_->screen();
        queue_passes();
        settle_later();
    }

    void subtract() override {
        ends_with_ = End::subtract;
        queue_end();
        settle_later();
    }

    void refine(bool halve) override {
        if (places_->queue_before_refine()) {
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
        return {samples_, survivors, places_->free_lengths(), places_->width()};
    }

    Snapshot snapshot() override {
        finish();
        Snapshot snapshot;
        round_.snapshot(snapshot);
        places_->snapshot(snapshot);
        return snapshot;
    }

    void restore(const Snapshot& snapshot) override {
        finish();
        places_->restore(snapshot);
        round_.restore_candidates(snapshot);
        places_->begin_round();
        sort();  // for the buckets' sake
        round_.restore_fates(snapshot);
        ends_with_ = End::none;
        has_fates_ = true;
    }

private:
    enum class End { none, subtract, refine };  // of the round

    void sort() {
        round_.sort();
        places_->look_up();
    }

    // Passes after the first kPasses take up what those left undecided.
    void queue_passes() {
        if (has_fates_) round_.begin_more_passes();
        for (std::uint32_t pass = has_fates_ ? 1 : 0; pass < kPasses; ++pass) places_->admit(pass);
        has_fates_ = true;
    }

    // Does nothing on the device while admission is unsettled.
    void queue_end() {
        if (ends_with_ == End::subtract) places_->subtract();
        if (ends_with_ == End::refine) places_->refine(halves_);
    }

    // What has been queued leaves something to find out at the round's end.
    void settle_later() {
        is_open_ = true;
        queue_->wait();
    }

    // Waits until the verbs are done, with what more they take: passes, room, samples left over.
    void finish() {
        if (!is_open_) return;
        while (true) {
            round_.start_download();
            places_->start_download();
            queue_->wait();
            round_.throw_if_failed();
            if (round_.is_unsettled()) {
                queue_passes();
                queue_end();
            } else if (!places_->queue_rest()) {
                break;
            }
        }
        places_->end_round();
        is_open_ = false;
        ends_with_ = End::none;
    }

    std::unique_ptr<Queue> queue_;
    RoundMemory round_;
    std::unique_ptr<Places> places_;
    std::vector<Sample> samples_;
    bool is_open_ = false;    // verbs whose outcome is not known yet
    bool has_fates_ = false;  // passes have something to take up
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
